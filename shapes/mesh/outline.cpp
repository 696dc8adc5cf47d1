// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes/mesh/outline.h"

#include <algorithm>
#include <limits>

namespace scree {

namespace {

Vec2 left_of(const Vec2& direction) { return {-direction.y, direction.x}; }

// Appends the arc that replaces a corner, or the corner itself.
void add_rounded(Ring& out, const Vec2& before, const Corner& corner, const Vec2& after,
                 int quarter) {
    const Vec2 at(corner.x, corner.y);
    const Vec2 in = (at - before).normalized();
    const Vec2 away = (after - at).normalized();
    const double turn = std::atan2(cross(in, away), in.dot(away));
    const double half_tangent = std::tan(std::abs(turn) / 2);
    // Slightly less than half of the shorter edge, so that arcs of adjacent corners stay apart.
    const double room = 0.49 * std::min((at - before).length(), (after - at).length());
    const double tangent = std::min(corner.radius * half_tangent, room);
    if (!(tangent > 1e-9 * room) || half_tangent < 1e-6) {
        out.push_back(at);
        return;
    }
    const double radius = tangent / half_tangent;
    const Vec2 start = at - in * tangent;
    const double side = turn > 0 ? 1 : -1;
    const Vec2 center = start + left_of(in) * (side * radius);
    const int segments = std::max(1, int(std::lround(std::abs(turn) / (pi / 2) * quarter)));
    for (int i = 0; i <= segments; ++i)
        out.push_back(center + rotate(start - center, turn * i / segments));
}

Vec2 mitre(const Ring& ring, std::size_t i) {
    const std::size_t n = ring.size();
    const Vec2 a = left_of((ring[i] - ring[(i + n - 1) % n]).normalized());
    const Vec2 b = left_of((ring[(i + 1) % n] - ring[i]).normalized());
    return (a + b) / (1 + a.dot(b));
}

} // namespace

Ring round_corners(const std::vector<Corner>& corners, int quarter) {
    Ring out;
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Corner& before = corners[(i + n - 1) % n];
        const Corner& after = corners[(i + 1) % n];
        add_rounded(out, {before.x, before.y}, corners[i], {after.x, after.y}, quarter);
    }
    return out;
}

Ring round_curve(const std::vector<Corner>& corners, int quarter) {
    Ring out{{corners.front().x, corners.front().y}};
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        add_rounded(out, {corners[i - 1].x, corners[i - 1].y}, corners[i],
                    {corners[i + 1].x, corners[i + 1].y}, quarter);
    out.emplace_back(corners.back().x, corners.back().y);
    return out;
}

Ring circle(double radius, int segments, const Vec2& center) {
    Ring out;
    for (int i = 0; i < segments; ++i)
        out.push_back(center + rotate({radius, 0.0}, 2 * pi * i / segments));
    return out;
}

Ring arc(const Vec2& center, double radius, double begin, double end, int segments) {
    Ring out;
    for (int i = 0; i <= segments; ++i)
        out.push_back(center + rotate({radius, 0.0}, begin + (end - begin) * i / segments));
    return out;
}

Ring inset(const Ring& ring, double distance) {
    Ring out;
    for (std::size_t i = 0; i < ring.size(); ++i)
        out.push_back(ring[i] + mitre(ring, i) * distance);
    return out;
}

double largest_inset(const Ring& ring) {
    double largest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const std::size_t next = (i + 1) % ring.size();
        const Vec2 edge = ring[next] - ring[i];
        // The length of an edge decreases linearly with the distance.
        const double fall = (mitre(ring, i) - mitre(ring, next)).dot(edge.normalized());
        if (fall > 0)
            largest = std::min(largest, edge.length() / fall);
    }
    return largest;
}

} // namespace scree
