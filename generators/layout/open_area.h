// SPDX-License-Identifier: GPL-3.0-or-later
// What is left of an area after convex polygons have been taken from it.
#pragma once

#include "generators/layout/no_fit.h"

#include <array>

namespace scree {

/// A convex polygon of few corners, counter-clockwise.
struct Fragment {
    static constexpr int capacity = 12;
    int count = 0;
    std::array<float, capacity> x, y;

    void add(float px, float py) {
        x[static_cast<std::size_t>(count)] = px;
        y[static_cast<std::size_t>(count)] = py;
        ++count;
    }
    float area() const;
    Vec2f centroid() const;
    Vec2f at(float u, float v) const; // uniformly distributed if u and v are in [0, 1)
    Imath::Box2f box() const;
};

Fragment box_fragment(const Imath::Box2f& box);

/// The part where x . normal <= offset; less than three corners when there is none. A polygon that
/// would have too many corners is returned uncut.
Fragment part_of(const Fragment& fragment, float normal_x, float normal_y, float offset);

/// Appends to `rest` what is left of the fragment outside the polygon, as convex fragments; it may
/// be more than what is left, never less, but for slivers thinner than `sliver` [m]. Returns
/// whether anything was taken.
bool subtract(const Fragment& fragment, const HalfPlanes& polygon, float sliver,
              std::vector<Fragment>& rest);

} // namespace scree
