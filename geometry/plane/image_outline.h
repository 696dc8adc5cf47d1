// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/plane/region.h"

#include <span>

namespace scree {

/// Numbers on a grid of pixels, row 0 first; pixel (i, j) has its middle at (i + 1/2, j + 1/2).
struct PixelGrid {
    int width = 0;
    int height = 0;
    std::span<const float> values; // width * height, finite
};

/// The outlines of where the values, interpolated between the pixels' middles, are at least
/// `threshold` (marching squares; Lorensen and Cline 1987 in the plane), in pixels. The area lies
/// to the left of its rings, which neither touch each other nor themselves: points keep 1/1024 of
/// a pixel away from the middles. Where two pixels above and two below meet crosswise, the
/// mean of the four decides whether the two above are joined. Nothing reaches beyond the image.
/// Rings around less than `min_area` square pixels are left out.
std::vector<Ring> image_outlines(const PixelGrid& pixels, float threshold, double min_area);

/// Removes points of rings as long as all removed points stay within `tolerance` of the edge that
/// replaces them, starting with those that move it least. Simple rings that do not touch stay so.
void simplify_within(std::vector<Ring>& rings, double tolerance);

} // namespace scree
