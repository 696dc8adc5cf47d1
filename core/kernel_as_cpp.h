// SPDX-License-Identifier: GPL-3.0-or-later
// The words of OpenCL C that our kernels use, in C++. The .cl files are compiled twice, by the
// host's compiler and by OpenCL's, so that there is one text of every kernel: `scree_kernel`
// (cmake/ScreeKernels.cmake) makes FILE_as_cpp.h of FILE.cl.
#pragma once

#include "core/parallel.h"

#include <bit>
#include <cmath>
#include <cstdint>

namespace scree::kernel_as_cpp {

using uchar = std::uint8_t;
using uint = std::uint32_t;
using ulong = std::uint64_t;

inline int as_int(float v) { return std::bit_cast<int>(v); }
inline float as_float(int v) { return std::bit_cast<float>(v); }

// One instruction each; the library's own look for NaN.
inline float fmax(float a, float b) { return a < b ? b : a; }
inline float fmin(float a, float b) { return b < a ? b : a; }

using std::atan2;
using std::cos;
using std::exp;
using std::fabs;
using std::floor;
using std::log2;
using std::sin;
using std::sqrt;

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
