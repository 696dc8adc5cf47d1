// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh.h"
#include "core/voxel_grid.h"

#include <vector>

namespace scree {

/// Distance to a mesh, negative inside, sampled at the centres of cubes and interpolated between.
class SignedDistanceGrid {
  public:
    SignedDistanceGrid() = default;

    /// `step` [m] between samples, coarser where there would be over `most` of them. The mesh is
    /// closed, or, with `thickness` [m] > 0, a sheet whose solid reaches half of that to both
    /// sides.
    SignedDistanceGrid(const Mesh& mesh, double step, double thickness = 0,
                       std::size_t most = std::size_t{1} << 22);

    /// Signed distance [m] at p; outside of the grid a bound from below that no point of the mesh
    /// is nearer than.
    float at(const Vec3& p) const;

    /// The same, with its gradient, of length near 1 but at the medial axis; outside of the grid
    /// that points away from it.
    float at(const Vec3& p, Vec3& gradient) const;

    double step() const { return grid_.side; }

  private:
    VoxelGrid grid_;
    Vec3 first_; // sample
    float inverse_step_ = 1;
    Vec3 last_; // cell, in steps from the first sample
    std::array<std::size_t, 3> stride_{};
    std::vector<float> values_;
};

} // namespace scree
