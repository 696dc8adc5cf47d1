// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces through a row of closed rings: revolutions, sweeps, caps.
#pragma once

#include "geometry/mesh/mesh.h"
#include "geometry/plane/region.h"

#include <span>

namespace scree {

/// A closed curve in space without its repeated last point.
using SpaceRing = std::vector<Vec3>;

/// The surface through `rings`, which have the same number of points each and turn right-handed
/// about the direction in which they follow each other; the normals then point outwards. A ring of
/// equal points is a pole. The ends stay open unless they are poles or the last ring repeats the
/// first. UVs: u around, v along by mean arc length. No normals yet.
Mesh loft(const std::vector<SpaceRing>& rings);

/// The circle of `radius` at height `y`, at the given angles about the y axis.
SpaceRing level_ring(std::span<const double> angles, double radius, double y);

/// `segments` equal angles.
std::vector<double> equal_angles(int segments);

/// `points` times one point: a pole.
SpaceRing pole(std::size_t points, const Vec3& at);

/// The surface that `profile`, points (radius, y) from bottom to top on the outside, sweeps about
/// the y axis. Closed when the profile begins and ends at radius 0 or where it began.
Mesh revolve(const Ring& profile, int segments);

} // namespace scree
