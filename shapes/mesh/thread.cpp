// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes/mesh/thread.h"

#include "shapes/mesh/loft.h"
#include "shapes/mesh/sweep.h"

#include <algorithm>

namespace scree {

namespace {

// One turn of the profile: the positions of its corners [pitches] and whether they lie on the
// crest.
struct ProfileCorner {
    double along;
    bool crest;
};
constexpr std::array<ProfileCorner, 4> thread_profile{
    {{0.0, false}, {0.25, false}, {0.5625, true}, {0.6875, true}}};
constexpr int corners = int(thread_profile.size());

} // namespace

Mesh thread_surface(std::span<const double> angles, const Thread& thread) {
    const int columns = int(angles.size());
    const double length = thread.top - thread.bottom;
    // Two more turns of rows at either end, which are clamped to the end circles.
    const int rows = (int(std::ceil(length / thread.pitch)) + 4) * corners;
    Mesh mesh;
    for (int j = 0; j <= rows; ++j) {
        for (int i = 0; i <= columns; ++i) {
            // Column `columns` is column 0, one turn further up.
            const int row = i == columns ? std::min(j + corners, rows) : j;
            const double angle = i == columns ? angles[0] : angles[i];
            const ProfileCorner& corner = thread_profile[std::size_t(row % corners)];
            const int whole_turns = row / corners - 2;
            const double turns = whole_turns + corner.along + angle / (2 * pi);
            const double y =
                std::clamp(thread.bottom + turns * thread.pitch, thread.bottom, thread.top);
            const double rise =
                std::clamp(std::min(y - thread.bottom, thread.top - y) / thread.fade, 0.0, 1.0);
            const double full = corner.crest ? thread.crest_radius : thread.root_radius;
            const double radius = thread.end_radius + (full - thread.end_radius) * rise;
            const SpaceRing point = level_ring(std::span(&angle, 1), radius, y);
            mesh.positions.push_back(point.front());
            mesh.uvs.emplace_back(i == columns ? 1.0F : static_cast<float>(angle / (2 * pi)),
                                  static_cast<float>((y - thread.bottom) / length));
        }
    }
    const bool inside = thread.crest_radius < thread.root_radius;
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const Vec3& p = mesh.positions[a];
        const Vec3& q = mesh.positions[b];
        const Vec3& r = mesh.positions[c];
        if (p == q || q == r || r == p)
            return; // degenerate: between clamped rows
        if (inside)
            std::swap(b, c);
        mesh.triangles.push_back({a, b, c});
    };
    const auto stride = static_cast<std::uint32_t>(columns + 1);
    for (std::uint32_t j = 0; j < std::uint32_t(rows); ++j)
        for (std::uint32_t i = 0; i + 1 < stride; ++i) {
            const std::uint32_t a = j * stride + i;
            add(a, a + 1, a + stride + 1);
            add(a, a + stride + 1, a + stride);
        }
    return mesh;
}

double thread_depth(double pitch) { return 0.625 * std::sqrt(3.0) / 2 * pitch; }

double coarse_pitch(double diameter) {
    static const std::vector<Vec2> table{{2, 0.4},  {3, 0.5},  {4, 0.7},   {5, 0.8}, {6, 1.0},
                                         {8, 1.25}, {10, 1.5}, {12, 1.75}, {16, 2},  {20, 2.5},
                                         {24, 3},   {30, 3.5}, {36, 4},    {48, 5},  {64, 6}};
    const double millimetres = diameter * 1000;
    if (millimetres < 2)
        return 0.2 * diameter;
    if (millimetres > 64)
        return 6.0 / 64 * diameter;
    return interpolate(table, millimetres) / 1000;
}

} // namespace scree
