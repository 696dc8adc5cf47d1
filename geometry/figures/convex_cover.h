// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/plane/region.h"

namespace scree {

/// Convex polygons, counter-clockwise, that together are the region: triangles merged over
/// diagonals as long as the result is convex (Hertel & Mehlhorn 1983). They share edges only.
std::vector<Ring> convex_partition(const Region& region);

/// Convex polygons, counter-clockwise, that lie in the region and together cover it: the partition,
/// parts joined and grown as far as the outline lets them, without those that others then cover.
std::vector<Ring> convex_cover(const Region& region);

/// A convex polygon of some of this one's vertices that no point of this one is farther than
/// `tolerance` [m] from.
Ring simplify_inward(const Ring& convex, double tolerance);

/// The part of a convex polygon where dot(normal, x) <= offset.
Ring cut(const Ring& convex, const Vec2& normal, double offset);

/// Points that see the whole region, a convex polygon; empty unless the region is star-shaped.
Ring kernel(const Region& region);

} // namespace scree
