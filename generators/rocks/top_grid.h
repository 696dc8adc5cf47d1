// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generators/rocks/box_grid.h"
#include "geometry/mesh/mesh.h"

namespace scree::rocks {

/// The triangles of a surface that face upwards, found by where they are seen from above.
class TopGrid {
  public:
    /// @param vertices relative to an origin that the caller keeps [m]
    TopGrid(std::vector<Vec3> vertices, std::span<const Mesh::Triangle> triangles);

    /// Calls found(a, b, c) for the triangles that may reach into the box (x, z), each once.
    template <class Found>
    void each_in(const Imath::Box2f& box, const Found& found) const {
        grid_.each_cell(box, [&](std::size_t cell) {
            for (const std::uint32_t k : grid_.members(cell)) {
                // In the first cell that both boxes reach into.
                const Vec2f corner(std::max(box.min.x, boxes_[k].min.x),
                                   std::max(box.min.y, boxes_[k].min.y));
                if (grid_.at(corner) != cell)
                    continue;
                const Mesh::Triangle& t = triangles_[k];
                found(vertices_[t[0]], vertices_[t[1]], vertices_[t[2]]);
            }
        });
    }

    const std::vector<Vec3>& vertices() const { return vertices_; }
    const std::vector<Mesh::Triangle>& triangles() const { return triangles_; }
    Box3 box() const;

  private:
    std::vector<Vec3> vertices_;
    std::vector<Mesh::Triangle> triangles_; // that face upwards
    std::vector<Imath::Box2f> boxes_;       // of each, seen from above
    BoxGrid grid_;
};

} // namespace scree::rocks
