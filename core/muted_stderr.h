// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <mutex>

namespace scree {

/// Silences the standard error stream of the process while it lives, for libraries that print what
/// they also report as errors, as libpng does. What other threads print meanwhile is lost too, so
/// it should not live long.
class MutedStderr {
  public:
    MutedStderr();
    ~MutedStderr();
    MutedStderr(const MutedStderr&) = delete;
    MutedStderr& operator=(const MutedStderr&) = delete;

  private:
    std::unique_lock<std::mutex> alone_; // two at once would not restore the stream
    int kept_;                           // the stream; negative when it could not be silenced
};

} // namespace scree
