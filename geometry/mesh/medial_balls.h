// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

#include <span>
#include <vector>

namespace scree {

/// A ball in a component's frame [m].
struct Ball {
    Vec3 centre;
    float radius = 0;
};

/// The inner poles of a dense sample of a closed surface: for every point the farthest vertex of
/// its Voronoi cell on the side that its normal (outwards, of length 1) turns away from, with the
/// ball round it that no point of the sample is in. They lie near the medial axis (Amenta, Choi &
/// Kolluri 2001). At most one a point; none where that side of the cell has no vertex.
std::vector<Ball> inner_poles(std::span<const Vec3> points, std::span<const Vec3> normals);

/// A subset of `balls` such that every one of `points` that any ball comes within `tolerance` [m]
/// of is so near to one of the subset: greedily, the ball that reaches most first, at most `most`.
/// `reached` tells by point whether that is so.
std::vector<Ball> covering_balls(std::span<const Ball> balls, std::span<const Vec3> points,
                                 double tolerance, std::size_t most, std::vector<bool>& reached);

} // namespace scree
