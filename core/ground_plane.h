// SPDX-License-Identifier: GPL-3.0-or-later
// What is seen from above: the ground plane (x, z) of a space with y up.
#pragma once

#include "core/region.h"

namespace scree {

/// x and z of the image of the ground's point (p.x, 0, p.y).
inline Vec2 ground_point(const Vec2& p, const Matrix& world_from_object) {
    const Matrix& m = world_from_object;
    return {p.x * double(m[0][0]) + p.y * double(m[2][0]) + double(m[3][0]),
            p.x * double(m[0][2]) + p.y * double(m[2][2]) + double(m[3][2])};
}

/// The region's rings where the matrix takes them; no triangles.
inline Region ground_region(const Region& region, const Matrix& world_from_object) {
    Region placed;
    for (const Ring& ring : region.rings)
        for (Ring& out = placed.rings.emplace_back(); const Vec2& point : ring)
            out.push_back(ground_point(point, world_from_object));
    return placed;
}

} // namespace scree
