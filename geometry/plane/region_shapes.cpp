// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/plane/region_shapes.h"

namespace scree {

namespace {

/// The outline drawn in [0, size] with its origin moved to the middle.
Ring centred(Ring ring, double width, double depth) {
    for (Vec2& v : ring)
        v -= Vec2(width / 2, depth / 2);
    return ring;
}

} // namespace

Ring rectangle_ring(double width, double depth) {
    return centred({{0, 0}, {width, 0}, {width, depth}, {0, depth}}, width, depth);
}

Ring circle_ring(double radius, int segments) {
    Ring ring;
    for (int i = 0; i < segments; ++i)
        ring.push_back(rotate({radius, 0}, 2 * pi * i / segments));
    return ring;
}

Ring star_ring(double radius, double inner, int points) {
    Ring ring;
    for (int i = 0; i < 2 * points; ++i)
        ring.push_back(rotate({i % 2 == 0 ? radius : radius * inner, 0}, pi * i / points));
    return ring;
}

Ring l_ring(double size, double stroke) {
    return centred({{0, 0}, {size, 0}, {size, stroke}, {stroke, stroke}, {stroke, size}, {0, size}},
                   size, size);
}

Ring u_ring(double size, double stroke) {
    return centred({{0, 0},
                    {size, 0},
                    {size, size},
                    {size - stroke, size},
                    {size - stroke, stroke},
                    {stroke, stroke},
                    {stroke, size},
                    {0, size}},
                   size, size);
}

Ring chevron_ring(double size, double stroke) {
    const double half = size / 2;
    return centred({{half, 0},
                    {size, half},
                    {size, half + stroke},
                    {half, stroke},
                    {0, half + stroke},
                    {0, half}},
                   size, half + stroke);
}

bool is_rectangle(const Region& region) {
    const Vec2 size = bounds(region).size();
    return region.rings.size() == 1 && region.rings[0].size() == 4 &&
           area(region) >= size.x * size.y * (1 - 1e-9);
}

} // namespace scree
