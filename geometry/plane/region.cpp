// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/plane/region.h"

#include <algorithm>
#include <limits>

namespace scree {

double signed_area(const Ring& ring) {
    double twice = 0;
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
        twice += cross(ring[j] - ring[0], ring[i] - ring[0]);
    return twice / 2;
}

double area(const Region& region) {
    double sum = 0;
    for (const Ring& ring : region.rings)
        sum += signed_area(ring);
    return sum;
}

Box2 bounds(const Region& region) {
    Box2 box;
    for (const Ring& ring : region.rings)
        for (const Vec2& point : ring)
            box.extendBy(point);
    return box;
}

bool contains(const Region& region, const Vec2& point) {
    bool inside = false;
    for (const Ring& ring : region.rings) {
        for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
            const Vec2& a = ring[j];
            const Vec2& b = ring[i];
            if ((a.y > point.y) == (b.y > point.y))
                continue;
            if (point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x))
                inside = !inside;
        }
    }
    return inside;
}

double segment_distance(const Vec2& point, const Vec2& a, const Vec2& b) {
    const Vec2 edge = b - a;
    const double length2 = edge.length2();
    const double t = length2 > 0 ? std::clamp((point - a).dot(edge) / length2, 0.0, 1.0) : 0.0;
    return (point - (a + edge * t)).length();
}

double signed_distance(const Region& region, const Vec2& point) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Ring& ring : region.rings)
        for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
            nearest = std::min(nearest, segment_distance(point, ring[j], ring[i]));
    return contains(region, point) ? -nearest : nearest;
}

} // namespace scree
