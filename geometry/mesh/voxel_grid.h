// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/mesh/mesh.h"

#include <cstdint>
#include <vector>

namespace scree {

/// Cubes side by side along x, y and z.
struct VoxelGrid {
    Imath::V3d corner{0.0, 0.0, 0.0}; // of the first cube, where x, y and z are least [m]
    double side = 1;                  // of a cube [m]
    std::array<int, 3> count{1, 1, 1};

    Imath::V3d centre(int i, int j, int k) const {
        return corner + Imath::V3d(i + 0.5, j + 0.5, k + 0.5) * side;
    }
    std::size_t size() const {
        return std::size_t(count[0]) * std::size_t(count[1]) * std::size_t(count[2]);
    }
    std::size_t index(int i, int j, int k) const { // x runs fastest
        return (std::size_t(k) * std::size_t(count[1]) + std::size_t(j)) * std::size_t(count[0]) +
               std::size_t(i);
    }
};

/// The grid round a mesh with `longest` cubes along its bounding box's longest side, at least one
/// along the others, in the middle of the box. Throws Error (input) for a mesh without extent.
VoxelGrid voxel_grid(const Mesh& mesh, int longest);

/// 1 for the voxels whose centre is inside a closed mesh, 0 for the others: where the surface
/// winds round the centre, so parts may overlap and either side may be the front. Centres exactly
/// on an edge are treated the same way for all its triangles.
std::vector<std::uint8_t> voxels_inside(const Mesh& mesh, const VoxelGrid& grid);

} // namespace scree
