// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/mesh/mesh.h"

#include <vector>

namespace scree {

/// Whether rays meet a mesh: its triangles in a grid of cubes, along which they are followed
/// (Amanatides & Woo 1987).
class MeshRays {
  public:
    explicit MeshRays(const Mesh& mesh);

    /// Whether the ray meets a triangle, from either side, farther than `from` [m] along
    /// `direction`, of length 1.
    bool hits(const Imath::V3d& origin, const Vec3& direction, double from) const;

  private:
    bool hits_triangle(std::uint32_t t, const Imath::V3d& origin, const Imath::V3d& direction,
                       double from) const;

    const Mesh* mesh_;
    Imath::Box3d box_;
    std::array<int, 3> count_{1, 1, 1};
    Imath::V3d side_;                  // of a cell
    std::vector<std::uint32_t> first_; // of each cell's triangles, and the end
    std::vector<std::uint32_t> triangles_;
};

} // namespace scree
