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

    /// Whether there is a KeepingWork.
    bool is_kept_waiting() const noexcept { return keepers_.load() > 0; }

  private:
    friend class KeepingWork;

    std::atomic<bool> requested_ = false;
    mutable std::atomic<int> keepers_ = 0;
};

/// Exists while a computation runs that ends by itself soon after a cancel was requested, and then
/// keeps what it has done: it is not to be ended by force.
class KeepingWork {
  public:
    /// Null: nobody can request a cancel.
    explicit KeepingWork(const Cancel* cancel) : cancel_(cancel) {
        if (cancel_ != nullptr)
            ++cancel_->keepers_;
    }
    KeepingWork(const KeepingWork&) = delete;
    KeepingWork& operator=(const KeepingWork&) = delete;
    ~KeepingWork() {
        if (cancel_ != nullptr)
            --cancel_->keepers_;
    }

  private:
    const Cancel* cancel_;
};

/// Called with the current stage and the fraction done in [0, 1]; from any thread, but never from
/// two at once.
using Progress = std::function<void(std::string_view what, double fraction)>;

} // namespace scree
