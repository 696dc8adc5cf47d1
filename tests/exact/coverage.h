// SPDX-License-Identifier: GPL-3.0-or-later
// Exact tests of whether disks cover a domain.
#pragma once

#include "geometry/plane/region.h"

#include <vector>

namespace scree::tests {

struct Disk {
    Vec2 centre;
    double radius = 0; // [m]
};

/// Counts candidate places of the domain that are farther than `radius` from all points. The
/// distance to the nearest point is convex in the part of the domain inside each Voronoi cell. So
/// its maxima lie at Voronoi vertices inside the domain, at crossings of Voronoi edges with the
/// domain's edges, or at the domain's corners. The count is 0 if and only if the domain is covered.
/// On a torus the domain is a periodic rectangle.
std::size_t far_places(const std::vector<Vec2>& points, const Region& domain, bool torus,
                       double radius);

/// Counts vertices of the disks' arrangement inside the domain that no open disk contains. Vertices
/// are crossings of two circles, crossings of a circle with the domain's border, corners of the
/// domain, and one point of each circle. The count is 0 if and only if the domain is covered,
/// except for isolated points. Proof: the boundary of an uncovered component consists of arcs of
/// circles and parts of the domain's border. If two of these meet, they do so in a vertex that lies
/// in no open disk. Otherwise the boundary contains a whole circle, none of whose points lies in
/// another open disk. (A whole ring of the domain has corners. On a torus the uncovered part has a
/// boundary if there is any disk.)
std::size_t bare_vertices(const std::vector<Disk>& disks, const Region& domain, bool torus);

} // namespace scree::tests
