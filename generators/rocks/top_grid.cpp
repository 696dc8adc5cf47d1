// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/rocks/top_grid.h"

#include <algorithm>

namespace scree::rocks {

namespace {

constexpr double triangles_per_cell = 1;
constexpr int most_columns = 4096;

bool faces_up(const Vec3& a, const Vec3& b, const Vec3& c) { return (b - a).cross(c - a).y > 0; }

} // namespace

TopGrid::TopGrid(std::vector<Vec3> vertices, std::span<const Mesh::Triangle> triangles)
    : vertices_(std::move(vertices)) {
    for (const Mesh::Triangle& t : triangles)
        if (faces_up(vertices_[t[0]], vertices_[t[1]], vertices_[t[2]]))
            triangles_.push_back(t);
    const Box3 box = this->box();
    low_ = {box.min.x, box.min.z};
    const Vec3 size = box.size();
    const double cells = std::max(1.0, double(triangles_.size()) / triangles_per_cell);
    const double side = std::max(std::sqrt(double(size.x) * double(size.z) / cells),
                                 double(std::max(size.x, size.z)) / most_columns);
    per_cell_ = side > 0 ? static_cast<float>(1 / side) : 1.0F;
    width_ = std::clamp(static_cast<int>(size.x * per_cell_) + 1, 1, most_columns);
    depth_ = std::clamp(static_cast<int>(size.z * per_cell_) + 1, 1, most_columns);

    // Counted, then filled: the members of a cell are in the order of the triangles.
    const auto each_cell = [&](const Mesh::Triangle& t, const auto& visit) {
        Imath::Box2f seen;
        for (const std::uint32_t i : t)
            seen.extendBy({vertices_[i].x, vertices_[i].z});
        for (int j = column(seen.min.y, low_.y, depth_); j <= column(seen.max.y, low_.y, depth_);
             ++j)
            for (int i = column(seen.min.x, low_.x, width_);
                 i <= column(seen.max.x, low_.x, width_); ++i)
                visit(std::size_t(j) * std::size_t(width_) + std::size_t(i));
    };
    starts_.assign(std::size_t(width_) * std::size_t(depth_) + 1, 0);
    for (const Mesh::Triangle& t : triangles_)
        each_cell(t, [&](std::size_t cell) { ++starts_[cell + 1]; });
    for (std::size_t i = 1; i < starts_.size(); ++i)
        starts_[i] += starts_[i - 1];
    members_.resize(starts_.back());
    std::vector<std::uint32_t> next(starts_.begin(), starts_.end() - 1);
    for (std::uint32_t k = 0; k < triangles_.size(); ++k)
        each_cell(triangles_[k], [&](std::size_t cell) { members_[next[cell]++] = k; });
}

Box3 TopGrid::box() const {
    Box3 box;
    for (const Mesh::Triangle& t : triangles_)
        for (const std::uint32_t i : t)
            box.extendBy(vertices_[i]);
    return box;
}

} // namespace scree::rocks
