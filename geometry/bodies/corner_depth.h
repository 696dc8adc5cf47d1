// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/bodies/ball_tree.h"
#include "geometry/mesh/voxel_grid.h"

namespace scree {

/// The corners of a mesh, to find how deep they lie in balls: eq. 4.2 of Sakurai (2013), looked up
/// ball by ball.
class CornerDepth {
  public:
    /// For balls of at most the radius `largest` [m]. `step` [m] is the cell size of a grid of
    /// distances to the corners, which is made coarser if it would have too many cells.
    CornerDepth(const std::vector<Vec3>& corners, double step, double largest);

    /// An upper bound of the depth of any corner in the ball [m], except for rounding: a single
    /// look-up.
    float bound(const Ball& ball) const {
        const Vec3 g = (ball.centre - low_) * inverse_step_;
        const Vec3 beyond(std::max(std::max(-g.x, g.x - high_.x), 0.0F),
                          std::max(std::max(-g.y, g.y - high_.y), 0.0F),
                          std::max(std::max(-g.z, g.z - high_.z), 0.0F));
        // The grid reaches beyond all corners by the largest radius: from outside no ball meets
        // one.
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

    /// The depth of the deepest corner in the ball, but at least `floor` [m].
    float depth(const Ball& ball, float floor) const {
        return corners_.depth_where(
            [&](const Vec3& p) { return (p - ball.centre).length() - ball.radius; }, floor);
    }

  private:
    BallTree corners_;
    VoxelGrid grid_;
    Vec3 low_;  // the lowest corner of the grid
    Vec3 high_; // its highest, in cells from the lowest
    float step_ = 1;
    float inverse_step_ = 1;
    std::vector<float> distance_; // of the cells' centres to the nearest corner [m]
};

} // namespace scree
