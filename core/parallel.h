// SPDX-License-Identifier: GPL-3.0-or-later
// Parallel loops on oneTBB. Results must not depend on how a loop is divided among threads.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>
#include <tbb/task_arena.h>

#include <cstddef>

namespace scree {

/// Limits all parallel loops to `threads` threads during its lifetime; 0 means no limit.
class ThreadLimit {
  public:
    explicit ThreadLimit(int threads)
        : control_(
              tbb::global_control::max_allowed_parallelism,
              static_cast<std::size_t>(threads > 0 ? threads : tbb::info::default_concurrency())) {}

  private:
    tbb::global_control control_;
};

inline int thread_count() {
    return static_cast<int>(
        tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

/// Calls body(i) for every i in [0, count), in chunks of about `grain` iterations or more.
template <class Body>
void parallel_for(std::size_t count, std::size_t grain, const Body& body) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, count, grain), [&](const auto& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i)
            body(i);
    });
}

/// Sorts by `less`. The sort is not stable, so `less` must be a strict total order for the result
/// to be deterministic.
template <class Iterator, class Less>
void parallel_sort(Iterator begin, Iterator end, const Less& less) {
    tbb::parallel_sort(begin, end, less);
}

} // namespace scree
