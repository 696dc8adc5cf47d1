// SPDX-License-Identifier: GPL-3.0-or-later
// The words of OpenCL C that the solid textures' .cl files use, in C++. These files are compiled
// twice, by the host's compiler and by OpenCL's, so that there is one text of every texture.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace scree::solid {

using uint = std::uint32_t;

inline int as_int(float v) { return std::bit_cast<int>(v); }
inline float as_float(int v) { return std::bit_cast<float>(v); }

using std::atan2;
using std::cos;
using std::exp;
using std::fabs;
using std::floor;
using std::fmax;
using std::fmin;
using std::log2;
using std::sin;
using std::sqrt;

} // namespace scree::solid
