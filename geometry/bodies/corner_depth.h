// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/bodies/ball_tree.h"
#include "geometry/mesh/voxel_grid.h"

namespace scree {

/// The corners of a mesh, for how deep they lie in balls: eq. 4.2 of Sakurai (2013) from the side
/// of the balls.
class CornerDepth {
  public:
    /// For balls of `largest` radius [m] at most; `step` [m] is that of a grid of distances to the
    /// corners, coarser where it would be large.
    CornerDepth(const std::vector<Vec3>& corners, double step, double largest);

    /// A depth [m] in the ball that no corner is deeper in, but for rounding: a look-up.
    float bound(const Ball& ball) const {
        const Vec3 g = (ball.centre - low_) * inverse_step_;
        const Vec3 beyond(std::max(std::max(-g.x, g.x - high_.x), 0.0F),
                          std::max(std::max(-g.y, g.y - high_.y), 0.0F),
                          std::max(std::max(-g.z, g.z - high_.z), 0.0F));
        // All corners are as far from the grid's rim as the largest ball is wide.
        if (const float beyond2 = beyond.length2(); beyond2 > 0)
            return -std::sqrt(beyond2) * step_;
        const int x = std::min(static_cast<int>(g.x), grid_.count[0] - 1);
        const int y = std::min(static_cast<int>(g.y), grid_.count[1] - 1);
        const int z = std::min(static_cast<int>(g.z), grid_.count[2] - 1);
        const Vec3 middle(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F,
                          static_cast<float>(z) + 0.5F);
        const float away = (g - middle).length() * step_;
        return ball.radius + away - distance_[grid_.index(x, y, z)];
    }

    /// The depth [m] of the deepest corner in the ball, or `floor` where that is more.
    float depth(const Ball& ball, float floor) const {
        return corners_.depth_where(
            [&](const Vec3& p) { return (p - ball.centre).length() - ball.radius; }, floor);
    }

  private:
    BallTree corners_;
    VoxelGrid grid_;
    Vec3 low_, high_; // corners of the grid, the upper in steps from the lower
    float step_ = 1;
    float inverse_step_ = 1;
    std::vector<float> distance_; // of the cells' centres to the nearest corner [m]
};

} // namespace scree
