// SPDX-License-Identifier: GPL-3.0-or-later
// The words of OpenCL C that the solid textures' .cl files use, in C++. These files are compiled
// twice, by the host's compiler and by OpenCL's, so that there is one text of every texture.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

// A function compiled twice, the second time for processors with AVX2, with all that it calls, and
// chosen when the program starts. Nothing is fused or reordered: both give the same bits.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define SCREE_FOR_PROCESSORS [[gnu::target_clones("avx2", "default"), gnu::flatten]]
#else
#define SCREE_FOR_PROCESSORS
#endif

namespace scree::solid {

using uint = std::uint32_t;

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

} // namespace scree::solid
