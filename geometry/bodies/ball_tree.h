// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/bodies/pose.h"
#include "geometry/mesh/medial_balls.h"
#include "geometry/mesh/signed_distance_grid.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

namespace scree {

/// Balls in a tree of balls that hold those below them, for the deepest of them in a neighbour.
class BallTree {
  public:
    BallTree() = default;
    explicit BallTree(std::vector<Ball> balls);

    /// How far the balls reach into a neighbour [m]: the greatest radius less distance to it, where
    /// `there` takes their frame to the neighbour's. Negative where they keep away. Exact between
    /// `floor` and `enough`; below `floor` it is that, and above `enough` any depth above it that
    /// some ball has.
    float depth_in(const SignedDistanceGrid& neighbour, const RelativePose& there, float floor,
                   float enough = std::numeric_limits<float>::max()) const;

    /// The same for what is at `distance(p)` from a point p of the balls' frame: a function that
    /// grows no faster than p moves.
    template <class Distance>
    float depth_where(const Distance& distance, float floor,
                      float enough = std::numeric_limits<float>::max()) const;

    /// The ball that reaches deepest, and how deep [m], likewise; none, of depth `floor`, where no
    /// ball is deeper.
    struct Deepest {
        Ball ball;
        float depth = std::numeric_limits<float>::lowest();
    };
    template <class Distance>
    Deepest deepest_where(const Distance& distance,
                          float floor = std::numeric_limits<float>::lowest()) const;

    /// Calls found(centre) for all balls that come within `gap` of what is at `distance`, likewise.
    template <class Distance, class Found>
    void each_within(const Distance& distance, float gap, const Found& found) const;

    /// All balls, in the tree's order.
    const std::vector<Ball>& balls() const { return balls_; }

  private:
    struct Node {
        Ball hull;
        std::uint32_t first = 0; // child, the second follows it; or ball of a leaf
        std::uint32_t count = 0; // of a leaf's balls, or 0
    };

    void split(std::uint32_t node, std::uint32_t first, std::uint32_t end);

    // As `depth_where`; deeper(ball) is called for each that is deeper than those before it.
    template <class Distance, class Deeper>
    float search(const Distance& distance, float floor, float enough, const Deeper& deeper) const;

    std::vector<Ball> balls_;
    std::vector<Node> nodes_;
};

template <class Distance>
float BallTree::depth_where(const Distance& distance, float floor, float enough) const {
    return search(distance, floor, enough, [](const Ball&) {});
}

template <class Distance, class Deeper>
float BallTree::search(const Distance& distance, float floor, float enough,
                       const Deeper& deeper) const {
    const auto depth = [&](const Ball& ball) { return ball.radius - distance(ball.centre); };
    struct Open {
        std::uint32_t node;
        float bound;
    };
    std::array<Open, 64> open; // one a level, and the tree is balanced
    std::size_t count = 0;
    float deepest = floor;
    if (!nodes_.empty())
        open[count++] = {0, depth(nodes_[0].hull)};
    while (count > 0 && deepest <= enough) {
        const Open next = open[--count];
        if (next.bound <= deepest)
            continue;
        const Node& node = nodes_[next.node];
        if (node.count > 0) {
            for (std::uint32_t b = node.first; b < node.first + node.count; ++b)
                if (const float d = depth(balls_[b]); d > deepest) {
                    deepest = d;
                    deeper(balls_[b]);
                }
            continue;
        }
        Open near{node.first, depth(nodes_[node.first].hull)};
        Open far{node.first + 1, depth(nodes_[node.first + 1].hull)};
        if (near.bound < far.bound)
            std::swap(near, far);
        if (far.bound > deepest)
            open[count++] = far;
        if (near.bound > deepest)
            open[count++] = near;
    }
    return deepest;
}

template <class Distance>
BallTree::Deepest BallTree::deepest_where(const Distance& distance, float floor) const {
    Deepest deepest{.ball = {}, .depth = floor};
    deepest.depth = search(distance, floor, std::numeric_limits<float>::max(),
                           [&](const Ball& ball) { deepest.ball = ball; });
    return deepest;
}

template <class Distance, class Found>
void BallTree::each_within(const Distance& distance, float gap, const Found& found) const {
    const auto is_within = [&](const Ball& ball) {
        return distance(ball.centre) - ball.radius < gap;
    };
    std::array<std::uint32_t, 64> open; // one a level, and the tree is balanced
    std::size_t count = 0;
    if (!nodes_.empty())
        open[count++] = 0;
    while (count > 0) {
        const Node& node = nodes_[open[--count]];
        if (!is_within(node.hull))
            continue;
        for (std::uint32_t b = node.first; b < node.first + node.count; ++b)
            if (is_within(balls_[b]))
                found(balls_[b].centre);
        if (node.count == 0) {
            open[count++] = node.first;
            open[count++] = node.first + 1;
        }
    }
}

} // namespace scree
