// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/stage_times.h"

namespace scree {

void StageTimes::end(const char* name) {
    const Clock::time_point now = Clock::now();
    seconds_.emplace_back(std::string(name) + "_seconds",
                          std::chrono::duration<double>(now - last_).count());
    last_ = now;
}

void StageTimes::add_to(Facts& facts) const {
    facts.insert(facts.end(), seconds_.begin(), seconds_.end());
    facts.emplace_back("seconds", std::chrono::duration<double>(last_ - start_).count());
}

} // namespace scree
