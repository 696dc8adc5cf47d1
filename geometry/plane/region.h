// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

#include <array>
#include <cstdint>
#include <vector>

namespace scree {

/// A triangulated polygon with holes, possibly of several parts: the exclusive region of a
/// component, or the domain of a layout. Outer rings turn counter-clockwise, holes clockwise, so
/// that a point is inside where the winding number is 1. Plain data: `triangulate` makes and checks
/// it.
struct Region {
    std::vector<Ring> rings;
    std::vector<Vec2> vertices;                          // of the triangulation
    std::vector<std::array<std::uint32_t, 3>> triangles; // counter-clockwise
};

/// Area [m^2]: outer rings less holes.
double area(const Region& region);
double signed_area(const Ring& ring);
Box2 bounds(const Region& region);

/// Even-odd test against the rings; points on an edge may go either way.
bool contains(const Region& region, const Vec2& point);

/// Distance from the point to the nearest edge [m], positive outside, negative inside.
double signed_distance(const Region& region, const Vec2& point);

/// Distance from a point to a segment [m].
double segment_distance(const Vec2& point, const Vec2& a, const Vec2& b);

} // namespace scree
