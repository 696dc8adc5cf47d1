// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh/line_crossing.h"

#include <algorithm>

namespace scree {

namespace {

using Vec3d = Imath::V3d;

// Which side of the line a-b the point is on, seen along z: 0 only for a = b, and exactly the
// opposite of the side of b-a, so that each point above a closed surface lies in as many triangles
// that face up as in triangles that face down.
int side_of(const Vec3d& a, const Vec3d& b, const Vec2& p) {
    if (b.x < a.x || (b.x == a.x && b.y < a.y))
        return -side_of(b, a, p);
    const double side = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
    if (side != 0)
        return side > 0 ? 1 : -1;
    // On the line: as if the point lay a little towards +x, and less towards +y (Edelsbrunner &
    // Muecke 1990, "Simulation of simplicity").
    if (b.y != a.y)
        return b.y < a.y ? 1 : -1;
    return b.x > a.x ? 1 : 0;
}

} // namespace

std::optional<LineCrossing> line_crossing(const std::array<Vec3d, 3>& v, const Vec2& p) {
    const int first = side_of(v[0], v[1], p);
    if (first == 0 || side_of(v[1], v[2], p) != first || side_of(v[2], v[0], p) != first)
        return {};
    const Vec3d normal = (v[1] - v[0]).cross(v[2] - v[0]);
    double z = v[0].z;
    if (normal.z != 0)
        z -= (normal.x * (p.x - v[0].x) + normal.y * (p.y - v[0].y)) / normal.z;
    const auto [low, high] = std::minmax({v[0].z, v[1].z, v[2].z});
    return LineCrossing{std::clamp(z, low, high), -first};
}

} // namespace scree
