// SPDX-License-Identifier: GPL-3.0-or-later
// The words of OpenCL C that our kernels use, in C++: include this, then, inside a namespace of
// your own, a .cl file; then run its kernels with `for_each_work_item`. No include guard is needed
// round the .cl file, but it must be the last thing that includes headers.
#pragma once

#include "core/parallel.h"

#include <cstdint>

namespace scree::kernel_as_cpp {

using uchar = std::uint8_t;
using uint = std::uint32_t;
using ulong = std::uint64_t;

inline thread_local std::size_t work_item = 0;
inline std::size_t get_global_id(int) { return work_item; }

/// Calls a kernel for every work item of a 1-D range, in parallel.
template <class Body>
void for_each_work_item(std::size_t count, const Body& body) {
    parallel_for(count, 16, [&](std::size_t i) {
        work_item = i;
        body();
    });
}

} // namespace scree::kernel_as_cpp

#define kernel static
#define global
