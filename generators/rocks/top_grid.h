// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/mesh/mesh.h"

#include <algorithm>
#include <span>

namespace scree::rocks {

/// The triangles of a surface that face upwards, found by where they are seen from above.
class TopGrid {
  public:
    /// @param vertices relative to an origin that the caller keeps [m]
    TopGrid(std::vector<Vec3> vertices, std::span<const Mesh::Triangle> triangles);

    /// Calls found(a, b, c) for the triangles that may reach into the box (x, z). One may be found
    /// more than once.
    template <class Found>
    void each_in(const Imath::Box2f& box, const Found& found) const {
        const int last_x = column(box.max.x, low_.x, width_);
        const int last_z = column(box.max.y, low_.y, depth_);
        for (int j = column(box.min.y, low_.y, depth_); j <= last_z; ++j)
            for (int i = column(box.min.x, low_.x, width_); i <= last_x; ++i) {
                const auto cell = std::size_t(j) * std::size_t(width_) + std::size_t(i);
                for (std::uint32_t k = starts_[cell]; k < starts_[cell + 1]; ++k) {
                    const Mesh::Triangle& t = triangles_[members_[k]];
                    found(vertices_[t[0]], vertices_[t[1]], vertices_[t[2]]);
                }
            }
    }

    const std::vector<Vec3>& vertices() const { return vertices_; }
    const std::vector<Mesh::Triangle>& triangles() const { return triangles_; }
    Box3 box() const;

  private:
    int column(float x, float low, int count) const {
        return std::clamp(static_cast<int>((x - low) * per_cell_), 0, count - 1);
    }

    std::vector<Vec3> vertices_;
    std::vector<Mesh::Triangle> triangles_; // that face upwards
    Vec2f low_{0.0F, 0.0F};                 // corner of the grid
    float per_cell_ = 1;
    int width_ = 1;
    int depth_ = 1;
    std::vector<std::uint32_t> starts_;  // of each cell in `members_`
    std::vector<std::uint32_t> members_; // numbers of triangles
};

} // namespace scree::rocks
