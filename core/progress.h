// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <string_view>

namespace scree {

/// Thrown by long work once cancelled; not a user's mistake.
struct Cancelled {};

/// A flag that a signal handler or another thread sets; long loops look at it.
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

/// Called from any one thread at a time with what is being done and how far it is, in [0, 1].
using Progress = std::function<void(std::string_view what, double fraction)>;

} // namespace scree
