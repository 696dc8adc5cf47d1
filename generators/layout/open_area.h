// SPDX-License-Identifier: GPL-3.0-or-later
// What is left of an area after convex polygons have been taken from it.
#pragma once

#include "geometry/figures/no_fit.h"

#include <array>

namespace scree {

/// A convex polygon of few corners, counter-clockwise.
struct Fragment {
    static constexpr int capacity = 12;
    int count = 0;
    std::array<float, capacity> x, y;
    Vec2f centre, half; // of the box around it; set by `close`

    void add(float px, float py) {
        x[static_cast<std::size_t>(count)] = px;
        y[static_cast<std::size_t>(count)] = py;
        ++count;
    }
    void close();
    float area() const;
    Vec2f centroid() const;
    Vec2f at(float u, float v) const; // uniformly distributed if u and v are in [0, 1)
    Imath::Box2f box() const { return {centre - half, centre + half}; }
};

Fragment box_fragment(const Imath::Box2f& box);

/// The part where x . normal <= offset; less than three corners when there is none. Instead of
/// a polygon that would have too many corners, the box around it is cut.
Fragment part_of(const Fragment& fragment, float normal_x, float normal_y, float offset);

/// Whether the polygon takes something of the fragment: then appends to `rest` what is left of it
/// outside the polygon, as convex fragments, but for slivers thinner than `sliver` [m]. What it
/// takes may be less than the polygon holds, never more.
bool subtract(const Fragment& fragment, const HalfPlanes& polygon, float sliver,
              std::vector<Fragment>& rest);

} // namespace scree
