// SPDX-License-Identifier: GPL-3.0-or-later
// Cubic B-splines through points.
#pragma once

#include "geometry/mesh/strands.h"

#include <span>

namespace scree {

/// Appends to `strands` (of bsplines) the cubic spline through two or more points, which it passes
/// in equal steps of its parameter and whose first and last pieces are parabolas (de Boor 1978, "A
/// practical guide to splines", chapter 4): straight ends would cut the corner. `radii`: one per
/// point; where they change so abruptly that the spline's would be negative they are 0.
void add_spline(Strands& strands, std::span<const Vec3> points, std::span<const float> radii);

/// Splines in place of chains of segments of about one length, each of which follows its chain by
/// pieces as long as `step` segments at the most, from end to end. Names, random numbers and frames
/// are kept.
Strands splined(const Strands& chains, int step = 3);

/// How far vertices of the chains lie from their splines at the most, in radii.
double spline_deviation(const Strands& chains, const Strands& splines);

/// A point of a piece of a uniform cubic B-spline with four control points.
Vec3 spline_point(const Vec3* control, float u);

} // namespace scree
