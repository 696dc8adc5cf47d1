// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generators/pile/medial_balls.h"
#include "generators/pile/pose.h"
#include "generators/pile/signed_distance_grid.h"

#include <cstdint>

namespace scree {

/// Balls in a tree of balls that hold those below them, for the deepest of them in a neighbour.
class BallTree {
  public:
    BallTree() = default;
    explicit BallTree(std::vector<Ball> balls);

    /// How far the balls reach into a neighbour [m]: the greatest radius less distance to it, where
    /// `there` takes their frame to the neighbour's. Negative where they keep away. Exact above
    /// `floor`; otherwise `floor`, which it does not exceed.
    float depth_in(const SignedDistanceGrid& neighbour, const RelativePose& there,
                   float floor) const;

    /// All balls, in the tree's order.
    const std::vector<Ball>& balls() const { return balls_; }

  private:
    struct Node {
        Ball hull;
        std::uint32_t first = 0; // child, the second follows it; or ball of a leaf
        std::uint32_t count = 0; // of a leaf's balls, or 0
    };

    void split(std::uint32_t node, std::uint32_t first, std::uint32_t end);

    std::vector<Ball> balls_;
    std::vector<Node> nodes_;
};

} // namespace scree
