// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/plane/convex_hull.h"

#include "geometry/plane/region.h"

#include <algorithm>
#include <limits>

namespace scree {

namespace {

bool lower(const Vec2& a, const Vec2& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

// Adds the points of a lower or upper chain, on which every corner turns left.
template <class Iterator>
void add_chain(Iterator from, Iterator to, std::vector<Vec2>& hull) {
    const std::size_t start = hull.size();
    for (; from != to; ++from) {
        while (hull.size() >= start + 2 &&
               cross(hull.back() - hull[hull.size() - 2], *from - hull[hull.size() - 2]) <= 0)
            hull.pop_back();
        hull.push_back(*from);
    }
    hull.pop_back(); // the other chain begins with it
}

} // namespace

std::vector<Vec2> convex_hull(std::vector<Vec2> points) {
    std::sort(points.begin(), points.end(), lower);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 3)
        return points;
    std::vector<Vec2> hull;
    add_chain(points.begin(), points.end(), hull);
    add_chain(points.rbegin(), points.rend(), hull);
    return hull;
}

bool in_convex_hull(const Vec2& point, std::vector<Vec2> points, double tolerance) {
    const std::vector<Vec2> hull = convex_hull(std::move(points));
    bool inside = hull.size() > 2;
    double distance = std::numeric_limits<double>::max();
    for (std::size_t k = 0; k < hull.size(); ++k) {
        const Vec2& a = hull[k];
        const Vec2& b = hull[(k + 1) % hull.size()];
        inside = inside && cross(b - a, point - a) >= 0;
        distance = std::min(distance, segment_distance(point, a, b));
    }
    return inside || distance <= tolerance;
}

} // namespace scree
