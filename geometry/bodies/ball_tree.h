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

/// Balls in a binary tree of bounding balls, to find those that reach deepest into a neighbour.
class BallTree {
  public:
    BallTree() = default;
    explicit BallTree(std::vector<Ball> balls);

    /// How deep the balls reach into a neighbour [m]: the greatest difference of a ball's radius
    /// and its centre's distance to the neighbour, negative if all are apart from it. `there` takes
    /// the balls' frame to the neighbour's. A depth of less than `floor` is returned as `floor`;
    /// the search ends at the first ball deeper than `enough`, and returns its depth.
    float depth_in(const SignedDistanceGrid& neighbour, const RelativePose& there, float floor,
                   float enough = std::numeric_limits<float>::max()) const;

    /// The same for any neighbour whose signed distance from a point p of the balls' frame is
    /// `distance(p)`, which must change no faster than p moves.
    template <class Distance>
    float depth_where(const Distance& distance, float floor,
                      float enough = std::numeric_limits<float>::max()) const;

    /// The ball that reaches deepest, and its depth [m]; if none is deeper than `floor`, no ball
    /// and that depth.
    struct Deepest {
        Ball ball;
        float depth = std::numeric_limits<float>::lowest();
    };
    template <class Distance>
    Deepest deepest_where(const Distance& distance,
                          float floor = std::numeric_limits<float>::lowest()) const;

    /// Calls found(centre) for all balls that are nearer than `gap` [m] to such a neighbour.
    template <class Distance, class Found>
    void each_within(const Distance& distance, float gap, const Found& found) const;

    /// All balls, in the tree's order.
    const std::vector<Ball>& balls() const { return balls_; }

  private:
    struct Node {
        Ball hull;
        std::uint32_t first =
            0; // its first child, which the second follows; of a leaf its first ball
        std::uint32_t count = 0; // of the leaf's balls; 0 if it is no leaf
    };

    void split(std::uint32_t node, std::uint32_t first, std::uint32_t end);

    // As `depth_where`; calls deeper(ball) for every ball that is the deepest so far.
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
    std::array<Open, 64> open; // at most one for each level, and the tree is balanced
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
    std::array<std::uint32_t, 64> open; // at most one for each level, and the tree is balanced
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
