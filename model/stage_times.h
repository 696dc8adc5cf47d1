// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/aggregate.h"

#include <chrono>

namespace scree {

/// The seconds that each stage of a bake takes.
class StageTimes {
  public:
    /// Ends the stage that began with the end of the one before.
    void end(const char* name);

    /// Adds the time of each stage and of all.
    void add_to(Facts& facts) const;

  private:
    using Clock = std::chrono::steady_clock;

    Clock::time_point start_ = Clock::now();
    Clock::time_point last_ = start_;
    Facts seconds_;
};

} // namespace scree
