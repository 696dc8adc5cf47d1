// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/bodies/advance.h"

#include <algorithm>

namespace scree {

namespace {

// In radii: how deep what counts as free may still reach, and the least step, without which a
// component that slides along another would never end.
constexpr double contact = 0.004;
constexpr double least_step = 0.02;

/// Two components, of which one's probe is held against the other's distance, or both's.
class Pair {
  public:
    Pair(const PileComponent& a, const Pose& pose_a, const PileComponent& b, const Pose& pose_b)
        : a_is_fine_(a.radius <= b.radius), fine_(a_is_fine_ ? &a : &b),
          coarse_(a_is_fine_ ? &b : &a),
          there_(a_is_fine_ ? relative(pose_a, pose_b) : relative(pose_b, pose_a)) {
        if (!fine_->probe_fills)
            back_ = a_is_fine_ ? relative(pose_b, pose_a) : relative(pose_a, pose_b);
    }

    /// `shift_in_a` and `shift_in_b`: how far a has moved, in either's frame.
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
    const PileComponent* fine_;
    const PileComponent* coarse_;
    RelativePose there_; // from the fine one's frame to the coarse one's
    RelativePose back_;
};

struct Neighbour {
    const Placed* placed;
    double distance2;
};

/// A neighbour on the way outwards.
struct Obstacle {
    Pair pair;
    Vec3 normal;       // the way's, in the neighbour's frame
    double allowed;    // depth [m]
    double free_until; // the height to which it has been shown to be no obstacle
};

} // namespace

double allowed_depth(const PileComponent& a, const PileComponent& b, double overlap) {
    return (overlap + contact) * std::min(a.radius, b.radius);
}

float depth_between(const PileComponent& a, const Pose& pose_a, const PileComponent& b,
                    const Pose& pose_b, float floor, float enough) {
    return Pair(a, pose_a, b, pose_b).depth(Vec3(0), Vec3(0), floor, enough);
}

bool is_free(const Pile& pile, const Placed& a, const Placed& b, double overlap) {
    const PileComponent& ca = pile.component(a);
    const PileComponent& cb = pile.component(b);
    const auto allowed = static_cast<float>(allowed_depth(ca, cb, overlap));
    return depth_between(ca, a.pose, cb, b.pose, allowed, allowed) <= allowed;
}

Advance advance(const Pile& pile, const PileSite& site, double from, double limit, double overlap) {
    const PileComponent& component = pile.kinds[site.kind].component;
    const Vec3 own_normal = site.normal * site.world_from_component.transposed();
    const Pose base = site.at(0).pose;
    // The nearest first: they are the most in the way.
    std::vector<Neighbour> neighbours;
    const Imath::V3d middle = site.at((from + limit) / 2).pose.centre;
    pile.hash.near(middle, component.reach + (limit - from) / 2, [&](std::uint32_t index) {
        const Placed& placed = pile.all[index];
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
                    height + std::max(obstacle.allowed - depth, 1e-6 * component.radius);
                break;
            }
            height += std::max(depth - obstacle.allowed, least_step * component.radius);
            moved = true;
        }
        return moved;
    };
    std::vector<Obstacle> obstacles;
    obstacles.reserve(neighbours.size());
    for (const Neighbour& neighbour : neighbours) {
        const PileComponent& other = pile.component(*neighbour.placed);
        obstacles.push_back({Pair(component, base, other, neighbour.placed->pose),
                             site.normal * neighbour.placed->pose.world_from_component.transposed(),
                             allowed_depth(component, other, overlap), from});
        pass(obstacles.back());
        if (height > limit)
            return {height, false};
    }
    // Until all in a row are none any more.
    for (std::size_t k = 0, passed = 0; passed < obstacles.size(); k = (k + 1) % obstacles.size()) {
        passed = pass(obstacles[k]) ? 0 : passed + 1;
        if (height > limit)
            return {height, false};
    }
    return {height, true};
}

} // namespace scree
