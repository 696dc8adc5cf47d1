// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces through a sequence of closed rings: revolutions, sweeps, caps.
#pragma once

#include "geometry/mesh/mesh.h"
#include "geometry/plane/region.h"

#include <span>

namespace scree {

/// A closed curve in space without its repeated last point.
using SpaceRing = std::vector<Vec3>;

/// The surface through `rings`, which have equal numbers of points. It faces outwards when the
/// rings wind right-handed about the direction in which they follow each other. A ring of equal
/// points is a pole. The ends stay open unless they are poles or the last ring equals the first.
/// UVs: u around, v along by mean arc length. Without normals.
Mesh loft(const std::vector<SpaceRing>& rings);

/// The circle of `radius` at height `y`, at the given angles about the y axis.
SpaceRing level_ring(std::span<const double> angles, double radius, double y);

/// `segments` equal angles.
std::vector<double> equal_angles(int segments);

/// A pole: a ring of `points` equal points.
SpaceRing pole(std::size_t points, const Vec3& at);

/// The surface of revolution of `profile` about the y axis: points (radius, y) from bottom to top
/// along the outside. Closed when the profile is closed or both its ends have radius 0.
Mesh revolve(const Ring& profile, int segments);

} // namespace scree
