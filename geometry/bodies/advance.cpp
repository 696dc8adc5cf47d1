// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/bodies/advance.h"

#include <algorithm>

namespace scree {

namespace {

// In radii of the smaller body.
constexpr double contact = 0.004; // how deep bodies that count as free may still reach
// Outwards; without it a body that slides along another would approach its end in ever smaller
// steps.
constexpr double least_step = 0.02;

/// Two bodies and how deep they are in each other. The finer one's probe is looked up in the
/// coarser one's distance; where that probe has single points, which a thin part may pass between,
/// the coarser one's probe is looked up in the finer one's distance too.
class Pair {
  public:
    Pair(const Body& a, const Pose& pose_a, const Body& b, const Pose& pose_b)
        : a_is_fine_(a.radius <= b.radius), fine_(a_is_fine_ ? &a : &b),
          coarse_(a_is_fine_ ? &b : &a),
          there_(a_is_fine_ ? relative(pose_a, pose_b) : relative(pose_b, pose_a)) {
        if (!fine_->probe_fills)
            back_ = a_is_fine_ ? relative(pose_b, pose_a) : relative(pose_a, pose_b);
    }

    /// The depth [m] when a has moved by the shift, which is given in the frames of both.
    float depth(const Vec3& shift_in_a, const Vec3& shift_in_b, float floor, float enough) const {
        RelativePose there = there_;
        there.offset += a_is_fine_ ? shift_in_b : -shift_in_a;
        const float depth = fine_->probe.depth_in(coarse_->distance, there, floor, enough);
        if (fine_->probe_fills || depth > enough)
            return depth;
        RelativePose back = back_;
        back.offset += a_is_fine_ ? -shift_in_a : shift_in_b;
        return coarse_->probe.depth_in(fine_->distance, back, depth, enough);
    }

  private:
    bool a_is_fine_;
    const Body* fine_;
    const Body* coarse_;
    RelativePose there_; // from the fine one's frame to the coarse one's
    RelativePose back_;
};

struct Neighbour {
    const PlacedBody* placed;
    double distance2;
};

/// A neighbour that may be in the way outwards.
struct Obstacle {
    Pair pair;
    Vec3 normal;       // the direction of the motion, in the neighbour's frame
    double allowed;    // depth [m]
    double free_until; // the height to which it has been shown to be no obstacle
};

} // namespace

double allowed_depth(const Body& a, const Body& b, double overlap) {
    return (overlap + contact) * std::min(a.radius, b.radius);
}

float depth_between(const Body& a, const Pose& pose_a, const Body& b, const Pose& pose_b,
                    float floor, float enough) {
    return Pair(a, pose_a, b, pose_b).depth(Vec3(0), Vec3(0), floor, enough);
}

bool is_free(const PlacedBodies& bodies, const PlacedBody& a, const PlacedBody& b, double overlap) {
    const Body& body_a = bodies.body(a);
    const Body& body_b = bodies.body(b);
    const auto allowed = static_cast<float>(allowed_depth(body_a, body_b, overlap));
    return depth_between(body_a, a.pose, body_b, b.pose, allowed, allowed) <= allowed;
}

Advance advance(const PlacedBodies& bodies, const BodySite& site, double from, double limit,
                double overlap) {
    const Body& body = *bodies.shapes[site.body];
    const Vec3 own_normal = site.normal * site.world_from_body.transposed();
    const Pose base = site.at(0).pose;
    // The nearest first, which are most likely to be in the way.
    std::vector<Neighbour> neighbours;
    const Imath::V3d middle = site.at((from + limit) / 2).pose.centre;
    bodies.hash.near(middle, body.reach + (limit - from) / 2, [&](std::uint32_t index) {
        const PlacedBody& placed = bodies.all[index];
        neighbours.push_back({&placed, (placed.pose.centre - middle).length2()});
    });
    std::sort(neighbours.begin(), neighbours.end(), [](const Neighbour& a, const Neighbour& b) {
        return std::pair(a.distance2, a.placed) < std::pair(b.distance2, b.placed);
    });

    double height = from;
    const auto pass = [&](Obstacle& obstacle) {
        bool moved = false;
        while (obstacle.free_until <= height && height <= limit) {
            const auto shift = static_cast<float>(height);
            const auto depth =
                double(obstacle.pair.depth(own_normal * shift, obstacle.normal * shift,
                                           static_cast<float>(height - limit + obstacle.allowed),
                                           static_cast<float>(obstacle.allowed)));
            if (depth <= obstacle.allowed) {
                obstacle.free_until =
                    height + std::max(obstacle.allowed - depth, 1e-6 * body.radius);
                break;
            }
            height += std::max(depth - obstacle.allowed, least_step * body.radius);
            moved = true;
        }
        return moved;
    };
    std::vector<Obstacle> obstacles;
    obstacles.reserve(neighbours.size());
    for (const Neighbour& neighbour : neighbours) {
        const Body& other = bodies.body(*neighbour.placed);
        obstacles.push_back({Pair(body, base, other, neighbour.placed->pose),
                             site.normal * neighbour.placed->pose.world_from_body.transposed(),
                             allowed_depth(body, other, overlap), from});
        pass(obstacles.back());
        if (height > limit)
            return {height, false};
    }
    // Past one obstacle it may be in an earlier one again: until a whole round moves it no more.
    for (std::size_t k = 0, passed = 0; passed < obstacles.size(); k = (k + 1) % obstacles.size()) {
        passed = pass(obstacles[k]) ? 0 : passed + 1;
        if (height > limit)
            return {height, false};
    }
    return {height, true};
}

} // namespace scree
