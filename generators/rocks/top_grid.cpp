// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/rocks/top_grid.h"

namespace scree::rocks {

namespace {

constexpr double triangles_per_cell = 1;
constexpr int most_columns = 4096;

bool faces_up(const Vec3& a, const Vec3& b, const Vec3& c) { return (b - a).cross(c - a).y > 0; }

} // namespace

TopGrid::TopGrid(std::vector<Vec3> vertices, std::span<const Mesh::Triangle> triangles)
    : vertices_(std::move(vertices)) {
    for (const Mesh::Triangle& t : triangles) {
        if (!faces_up(vertices_[t[0]], vertices_[t[1]], vertices_[t[2]]))
            continue;
        triangles_.push_back(t);
        Imath::Box2f& seen = boxes_.emplace_back();
        for (const std::uint32_t i : t)
            seen.extendBy({vertices_[i].x, vertices_[i].z});
    }
    grid_.fill(boxes_, triangles_per_cell, most_columns);
}

Box3 TopGrid::box() const {
    Box3 box;
    for (const Mesh::Triangle& t : triangles_)
        for (const std::uint32_t i : t)
            box.extendBy(vertices_[i]);
    return box;
}

} // namespace scree::rocks
