// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes/mesh/rounded_box.h"

namespace scree {

namespace {

constexpr int quarter = 6; // segments per eighth of a turn

// A grid line of a face: its position on the flat part in [-1, 1], and the tangent of the angle by
// which the rounded edge has turned there, in [-1, 1].
struct Line {
    double flat;
    double turn;
};

std::vector<Line> grid_lines(bool rounded, const std::vector<double>& inner_lines) {
    std::vector<Line> lines;
    // tan(45 degrees) must be exactly 1 so that adjacent faces have equal vertices.
    const auto tangent = [](int k) {
        return k == quarter ? 1.0 : std::tan(pi / 4 * double(k) / quarter);
    };
    for (int k = rounded ? quarter : 0; k >= 0; --k)
        lines.push_back({-1, -tangent(k)});
    for (const double line : inner_lines)
        lines.push_back({line, 0});
    for (int k = 0; k <= (rounded ? quarter : 0); ++k)
        lines.push_back({1, tangent(k)});
    return lines;
}

} // namespace

Mesh rounded_box(const Vec3& sides, double radius, const std::vector<double>& inner_lines,
                 const FaceRelief& relief) {
    const std::vector<Line> lines = grid_lines(radius > 0, inner_lines);
    const auto n = static_cast<std::uint32_t>(lines.size());
    const Imath::V3d half = Imath::V3d(sides) / 2;
    Mesh mesh;
    for (int face = 0; face < 6; ++face) {
        const int w = face / 2; // axis of the face's normal
        const double side = face % 2 == 0 ? 1 : -1;
        const int u = (w + 1) % 3;
        const int v = (w + 2) % 3;
        const auto base = static_cast<std::uint32_t>(mesh.positions.size());
        for (const Line& b : lines) {
            for (const Line& a : lines) {
                Imath::V3d normal;
                normal[u] = a.turn * side; // mirrored with the face
                normal[v] = b.turn;
                normal[w] = side;
                normal.normalize();
                Imath::V3d p;
                p[u] = a.flat * side * (half[u] - radius);
                p[v] = b.flat * (half[v] - radius);
                p[w] = side * (half[w] - radius);
                p += normal * radius;
                if (relief)
                    p[w] -= side * relief(a.flat, b.flat);
                mesh.positions.emplace_back(p);
                mesh.normals.emplace_back(normal);
                const Imath::V3d square = p / half;
                mesh.uvs.emplace_back(static_cast<float>(0.5 + 0.5 * side * square[u]),
                                      static_cast<float>(0.5 + 0.5 * square[v]));
            }
        }
        for (std::uint32_t j = 0; j + 1 < n; ++j)
            for (std::uint32_t i = 0; i + 1 < n; ++i) {
                const std::uint32_t c = base + j * n + i;
                mesh.triangles.push_back({c, c + 1, c + n + 1});
                mesh.triangles.push_back({c, c + n + 1, c + n});
            }
    }
    if (relief)
        mesh.normals.clear();
    return mesh;
}

} // namespace scree
