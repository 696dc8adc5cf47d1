// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes/mesh/loft.h"

#include <cassert>

namespace scree {

namespace {

// The position of each ring along the surface, in [0, 1], by mean arc length.
std::vector<float> arc_lengths(const std::vector<SpaceRing>& rings) {
    std::vector<double> along(rings.size(), 0.0);
    for (std::size_t j = 1; j < rings.size(); ++j) {
        double sum = 0;
        for (std::size_t i = 0; i < rings[j].size(); ++i)
            sum += double((rings[j][i] - rings[j - 1][i]).length());
        along[j] = along[j - 1] + sum / double(rings[j].size());
    }
    std::vector<float> out;
    for (const double a : along)
        out.push_back(static_cast<float>(along.back() > 0 ? a / along.back() : 0));
    return out;
}

void add_triangle(Mesh& mesh, const Mesh::Triangle& t) {
    const Vec3& a = mesh.positions[t[0]];
    const Vec3& b = mesh.positions[t[1]];
    const Vec3& c = mesh.positions[t[2]];
    if (a != b && b != c && c != a) // at a pole one triangle of a quad is degenerate
        mesh.triangles.push_back(t);
}

} // namespace

Mesh loft(const std::vector<SpaceRing>& rings) {
    const std::size_t n = rings.front().size();
    const std::vector<float> v = arc_lengths(rings);
    Mesh mesh;
    for (std::size_t j = 0; j < rings.size(); ++j) {
        assert(rings[j].size() == n);
        for (std::size_t i = 0; i <= n; ++i) {
            mesh.positions.push_back(rings[j][i % n]);
            mesh.uvs.emplace_back(static_cast<float>(i) / static_cast<float>(n), v[j]);
        }
    }
    const auto stride = static_cast<std::uint32_t>(n + 1);
    for (std::uint32_t j = 0; j + 1 < rings.size(); ++j) {
        for (std::uint32_t i = 0; i < n; ++i) {
            const std::uint32_t a = j * stride + i;
            add_triangle(mesh, {a, a + 1, a + stride + 1});
            add_triangle(mesh, {a, a + stride + 1, a + stride});
        }
    }
    return mesh;
}

SpaceRing level_ring(std::span<const double> angles, double radius, double y) {
    SpaceRing ring;
    for (const double angle : angles)
        ring.emplace_back(static_cast<float>(radius * std::cos(angle)), static_cast<float>(y),
                          static_cast<float>(-radius * std::sin(angle)));
    return ring;
}

std::vector<double> equal_angles(int segments) {
    std::vector<double> angles;
    for (int i = 0; i < segments; ++i)
        angles.push_back(2 * pi * i / segments);
    return angles;
}

SpaceRing pole(std::size_t points, const Vec3& at) { return SpaceRing(points, at); }

Mesh revolve(const Ring& profile, int segments) {
    const std::vector<double> angles = equal_angles(segments);
    std::vector<SpaceRing> rings;
    for (const Vec2& p : profile)
        rings.push_back(p.x > 0 ? level_ring(angles, p.x, p.y)
                                : pole(angles.size(), Vec3(0, static_cast<float>(p.y), 0)));
    return loft(rings);
}

} // namespace scree
