// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/fibres/spline.h"

#include <algorithm>
#include <limits>

namespace scree::fibres {

namespace {

/// The control points of a uniform cubic B-spline through the values: (a + 4 b + c) / 6 of three in
/// a row is the value, and at the ends a - 2 b + c is as of the three values there.
template <class T>
std::vector<T> control_points(const std::vector<T>& through) {
    const std::size_t last = through.size() - 1;
    const auto bend = [&](std::size_t a, std::size_t b, std::size_t c) {
        return last < 2 ? through[0] * 0.0F : through[a] - through[b] * 2.0F + through[c];
    };
    const T first_bend = bend(0, 1, 2);
    const T last_bend = bend(last, last - 1, last < 2 ? 0 : last - 2);
    std::vector<T> c = through;
    c[0] -= first_bend / 6.0F;
    c[last] -= last_bend / 6.0F;
    std::vector<float> upper(through.size(), 0.0F); // Thomas's algorithm on 1 4 1
    for (std::size_t i = 1; i < last; ++i) {
        upper[i] = 1 / (4 - upper[i - 1]);
        c[i] = (through[i] * 6.0F - c[i - 1]) * upper[i];
    }
    for (std::size_t i = last; i-- > 1;)
        c[i] -= c[i + 1] * upper[i];
    std::vector<T> points;
    points.reserve(c.size() + 2);
    points.push_back(c[0] * 2.0F - c[1] + first_bend);
    points.insert(points.end(), c.begin(), c.end());
    points.push_back(c[last] * 2.0F - c[last - 1] + last_bend);
    return points;
}

Vec3 point_on(const Vec3* p, float t) {
    const float u = 1 - t;
    return (p[0] * (u * u * u) + p[1] * (3 * t * t * t - 6 * t * t + 4) +
            p[2] * (3 * u * u * u - 6 * u * u + 4) + p[3] * (t * t * t)) /
           6.0F;
}

float distance_to(const Vec3& p, const Vec3& a, const Vec3& b) {
    const Vec3 along = b - a;
    const float length2 = along.length2();
    const float t = length2 > 0 ? std::clamp((p - a).dot(along) / length2, 0.0F, 1.0F) : 0;
    return (p - a - along * t).length();
}

/// Distance of p from the pieces beside `piece` and from itself.
float distance_from(const std::vector<Vec3>& control, std::size_t piece, const Vec3& p) {
    constexpr int steps = 12;
    const std::size_t end = std::min(piece + 2, control.size() - 3);
    float least = std::numeric_limits<float>::max();
    for (std::size_t i = piece > 0 ? piece - 1 : 0; i < end; ++i) {
        Vec3 before = point_on(&control[i], 0);
        for (int k = 1; k <= steps; ++k) {
            const Vec3 next = point_on(&control[i], static_cast<float>(k) / steps);
            least = std::min(least, distance_to(p, before, next));
            before = next;
        }
    }
    return least;
}

} // namespace

Spline spline_of(std::span<const Vec3> chain, const FibreShape& shape) {
    const std::uint32_t pieces = spline_pieces(shape.segments);
    std::vector<Vec3> through;
    std::vector<float> radii;
    for (std::uint32_t i = 0; i <= pieces; ++i) {
        const std::uint32_t vertex = std::min(3 * i, shape.segments);
        through.push_back(chain[vertex]);
        radii.push_back(shape.radius_at(vertex));
    }
    Spline spline{.points = control_points(through), .radii = control_points(radii)};
    for (float& radius : spline.radii)
        radius = std::max(radius, 0.0F);
    for (std::uint32_t v = 0; v <= shape.segments; ++v)
        spline.excess = std::max(
            spline.excess, distance_from(spline.points, std::min(v / 3, pieces - 1), chain[v]));
    return spline;
}

} // namespace scree::fibres
