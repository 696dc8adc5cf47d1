// SPDX-License-Identifier: GPL-3.0-or-later
// Outlines of simple regions around their centres, counter-clockwise.
#pragma once

#include "geometry/plane/region.h"

namespace scree {

Ring rectangle_ring(double width, double depth); // [m], centred at the origin

/// A regular polygon with `segments` corners on a circle of `radius` [m] about the origin.
Ring circle_ring(double radius, int segments);

/// A star with `points` tips at `radius` and as many inner corners at `radius * inner`.
Ring star_ring(double radius, double inner, int points);

/// Letters in a square of side `size` with strokes of `stroke` [m], and a V opening upwards whose
/// arms rise by `size / 2`.
Ring l_ring(double size, double stroke);
Ring u_ring(double size, double stroke);
Ring chevron_ring(double size, double stroke);

/// Whether the region is one rectangle along x and z, to within 1e-9 of its area.
bool is_rectangle(const Region& region);

} // namespace scree
