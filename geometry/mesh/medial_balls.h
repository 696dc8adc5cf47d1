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
/// its Voronoi cell on the inner side (against its normal, which points outwards and has length 1),
/// with the largest ball around it that contains no point of the sample. They lie near the medial
/// axis (Amenta, Choi & Kolluri 2001). At most one per point; none where that side of the cell has
/// no vertex.
std::vector<Ball> inner_poles(std::span<const Vec3> points, std::span<const Vec3> normals);

/// A subset of `balls`, at most `most` of them, that comes within `tolerance` [m] of every one of
/// `points` that any ball comes so near to. Chosen greedily: first the ball that reaches most
/// points. `reached` tells for each point whether the subset reaches it.
std::vector<Ball> covering_balls(std::span<const Ball> balls, std::span<const Vec3> points,
                                 double tolerance, std::size_t most, std::vector<bool>& reached);

} // namespace scree
