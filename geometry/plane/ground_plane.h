// SPDX-License-Identifier: GPL-3.0-or-later
// What is seen from above: the ground plane (x, z) of a space with y up.
#pragma once

#include "geometry/plane/region.h"

namespace scree {

/// x and z of the image of the ground's point (p.x, 0, p.y).
inline Vec2 ground_point(const Vec2& p, const WideMatrix& world_from_object) {
    const WideMatrix& m = world_from_object;
    return {p.x * m[0][0] + p.y * m[2][0] + m[3][0], p.x * m[0][2] + p.y * m[2][2] + m[3][2]};
}

/// The region's rings where the matrix takes them; no triangles.
inline Region ground_region(const Region& region, const WideMatrix& world_from_object) {
    Region placed;
    for (const Ring& ring : region.rings)
        for (Ring& out = placed.rings.emplace_back(); const Vec2& point : ring)
            out.push_back(ground_point(point, world_from_object));
    return placed;
}

/// Takes `centre` of an element's x-z plane to the origin, scales, turns from +x towards +z, moves
/// to `position` and lifts by `height` [m]; y = 0 stays the ground.
inline WideMatrix world_from_element(const Vec2& centre, const Vec2& position, double angle,
                                     double scale, double height) {
    const Vec2 x = rotate({scale, 0}, angle);
    const Vec2 z = rotate({0, scale}, angle);
    const Vec2 t = position - x * centre.x - z * centre.y;
    return {x.x, 0, x.y, 0, 0, scale, 0, 0, z.x, 0, z.y, 0, t.x, height, t.y, 1};
}

} // namespace scree
