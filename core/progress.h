// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <string_view>

namespace scree {

/// Thrown by a long computation after it was cancelled; not an error.
struct Cancelled {};

/// A flag that a signal handler or another thread sets and long loops check.
class Cancel {
  public:
    void request() noexcept { requested_.store(true, std::memory_order_relaxed); }
    bool requested() const noexcept { return requested_.load(std::memory_order_relaxed); }
    void check() const {
        if (requested())
            throw Cancelled{};
    }

  private:
    std::atomic<bool> requested_ = false;
};

/// Called with the current stage and the fraction done in [0, 1]; from any thread, but never from
/// two at once.
using Progress = std::function<void(std::string_view what, double fraction)>;

} // namespace scree
