// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image.h"

#include <cstdint>
#include <vector>

namespace scree {

/// For every texel of a texture that wraps round the one nearest to it among those of `covered`
/// (row by row, at least one): itself where it is covered. Exact Euclidean distances, in linear
/// time (Meijster, Roerdink & Hesselink 2000; Felzenszwalb & Huttenlocher 2012).
std::vector<std::uint32_t> nearest_covered(int width, int height, const std::vector<bool>& covered);

/// Gives what is not covered the value of the nearest covered texel, so that neither bilinear
/// look-ups nor halvings of the texture ever meet a background.
void fill_gutter(Image& image, const std::vector<bool>& covered);

} // namespace scree
