// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/bodies/ball_tree.h"

namespace scree {

namespace {

constexpr std::uint32_t leaf_size = 4;

Ball hull_of(std::span<const Ball> balls) {
    Box3 box;
    for (const Ball& ball : balls) {
        box.extendBy(ball.centre - Vec3(ball.radius));
        box.extendBy(ball.centre + Vec3(ball.radius));
    }
    Ball hull{box.center(), 0};
    for (const Ball& ball : balls)
        hull.radius = std::max(hull.radius, (ball.centre - hull.centre).length() + ball.radius);
    return hull;
}

} // namespace

BallTree::BallTree(std::vector<Ball> balls) : balls_(std::move(balls)) {
    if (balls_.empty())
        return;
    nodes_.emplace_back();
    split(0, 0, static_cast<std::uint32_t>(balls_.size()));
}

void BallTree::split(std::uint32_t node, std::uint32_t first, std::uint32_t end) {
    const std::span<Ball> part(balls_.data() + first, end - first);
    nodes_[node].hull = hull_of(part);
    if (part.size() <= leaf_size) {
        nodes_[node].first = first;
        nodes_[node].count = end - first;
        return;
    }
    Box3 box;
    for (const Ball& ball : part)
        box.extendBy(ball.centre);
    const auto axis = static_cast<int>(box.majorAxis());
    const std::uint32_t middle = first + (end - first) / 2;
    std::nth_element(balls_.begin() + first, balls_.begin() + middle, balls_.begin() + end,
                     [axis](const Ball& a, const Ball& b) {
                         return a.centre[axis] != b.centre[axis] ? a.centre[axis] < b.centre[axis]
                                                                 : a.radius < b.radius;
                     });
    const auto children = static_cast<std::uint32_t>(nodes_.size());
    nodes_[node].first = children;
    nodes_.resize(nodes_.size() + 2);
    split(children, first, middle);
    split(children + 1, middle, end);
}

float BallTree::depth_in(const SignedDistanceGrid& neighbour, const RelativePose& there,
                         float floor, float enough) const {
    return depth_where([&](const Vec3& p) { return neighbour.at(there(p)); }, floor, enough);
}

} // namespace scree
