// SPDX-License-Identifier: GPL-3.0-or-later
// Whether disks cover a domain, decided in exact arithmetic.
#pragma once

#include "geometry/plane/region.h"

#include <vector>

namespace scree::tests {

struct Disk {
    Vec2 centre;
    double radius = 0; // [m]
};

/// Places of the domain that are further than `radius` from all points, counted among those that
/// can be the furthest: the distance to the nearest point is convex over each Voronoi cell's part
/// of the domain, so its largest values are at Voronoi vertices inside the domain, where Voronoi
/// edges cross the domain's edges, and at the domain's corners. None if and only if the domain is
/// covered. On a torus the domain is a rectangle that repeats.
std::size_t far_places(const std::vector<Vec2>& points, const Region& domain, bool torus,
                       double radius);

/// Places of the domain that no open disk contains, counted among the vertices of the disks'
/// arrangement: where two circles cross, where a circle crosses the domain's border, the domain's
/// corners, and one point of each circle. None if and only if the domain is covered, up to single
/// points: take a connected part of what is not covered. Its closure's border consists of arcs of
/// circles and pieces of the domain's border. Either there is a place where two of them meet, which
/// is one of the vertices and lies in no open disk; or the border holds a whole circle, of which
/// then no point lies in another open disk. (A whole ring of the domain has corners. On a torus
/// what is not covered has a border if there is a disk at all.)
std::size_t bare_vertices(const std::vector<Disk>& disks, const Region& domain, bool torus);

} // namespace scree::tests
