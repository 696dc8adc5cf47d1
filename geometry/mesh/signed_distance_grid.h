// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/mesh/mesh.h"
#include "geometry/mesh/voxel_grid.h"

#include <algorithm>
#include <vector>

namespace scree {

/// Distance to a mesh, negative inside, sampled at the centres of cubes and interpolated between.
class SignedDistanceGrid {
  public:
    SignedDistanceGrid() = default;

    /// `step` [m] between samples, coarser where there would be over `most` of them. The mesh is
    /// closed, or, with `thickness` [m] > 0, a sheet whose solid reaches half of that to both
    /// sides. Within `margin` [m] of the mesh's box the distance is as good as inside.
    SignedDistanceGrid(const Mesh& mesh, double step, double thickness = 0,
                       std::size_t most = std::size_t{1} << 22, double margin = 0);

    /// Signed distance [m] at p; outside of the grid a bound from below that no point of the mesh
    /// is nearer than.
    float at(const Vec3& p) const;

    /// The same, with its gradient, of length near 1 but at the medial axis; outside of the grid
    /// that points away from it.
    float at(const Vec3& p, Vec3& gradient) const;

    double step() const { return grid_.side; }

    /// The cubes at whose centres the samples lie.
    const VoxelGrid& grid() const { return grid_; }
    const std::vector<float>& samples() const { return values_; }

  private:
    VoxelGrid grid_;
    Vec3 first_; // sample
    float inverse_step_ = 1;
    Vec3 last_; // cell, in steps from the first sample
    std::array<std::size_t, 3> stride_{};
    std::vector<float> values_;
};

inline float SignedDistanceGrid::at(const Vec3& p) const {
    const Vec3 g = (p - first_) * inverse_step_;
    const Vec3 c(std::clamp(g.x, 0.0F, last_.x), std::clamp(g.y, 0.0F, last_.y),
                 std::clamp(g.z, 0.0F, last_.z));
    // None is negative, so that truncation is the floor.
    const int x = std::min(static_cast<int>(c.x), grid_.count[0] - 2);
    const int y = std::min(static_cast<int>(c.y), grid_.count[1] - 2);
    const int z = std::min(static_cast<int>(c.z), grid_.count[2] - 2);
    const float u = c.x - static_cast<float>(x);
    const float v = c.y - static_cast<float>(y);
    const float w = c.z - static_cast<float>(z);
    const float* near = values_.data() + static_cast<std::size_t>(x) +
                        static_cast<std::size_t>(y) * stride_[1] +
                        static_cast<std::size_t>(z) * stride_[2];
    const float* far = near + stride_[2];
    const auto along_x = [u](const float* f) { return f[0] + u * (f[1] - f[0]); };
    const auto in_plane = [&](const float* f) {
        const float low = along_x(f);
        return low + v * (along_x(f + stride_[1]) - low);
    };
    const float low = in_plane(near);
    const float inside = low + w * (in_plane(far) - low);
    const float beyond2 = (g - c).length2();
    if (beyond2 == 0)
        return inside;
    // The mesh lies in the grid's box: the way to the box and the way on make a right or obtuse
    // angle.
    const auto step = static_cast<float>(grid_.side);
    return std::sqrt(beyond2 * step * step + inside * inside);
}

} // namespace scree
