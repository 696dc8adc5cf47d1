// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/pile/advance.h"

#include <algorithm>

namespace scree {

namespace {

// In radii: how deep what counts as free may still reach, and the least step, without which a
// component that slides along another would never end.
constexpr double contact = 0.004;
constexpr double least_step = 0.02;

double allowed_depth(const PileComponent& a, const PileComponent& b, double overlap) {
    return (overlap + contact) * std::min(a.radius, b.radius);
}

struct Neighbour {
    const Placed* placed;
    double free_until; // the height to which it has been shown to be free of it
};

} // namespace

float depth_between(const PileComponent& a, const Pose& pose_a, const PileComponent& b,
                    const Pose& pose_b, float floor) {
    const bool a_is_finer = a.radius <= b.radius;
    const PileComponent& fine = a_is_finer ? a : b;
    const PileComponent& coarse = a_is_finer ? b : a;
    const Pose& fine_pose = a_is_finer ? pose_a : pose_b;
    const Pose& coarse_pose = a_is_finer ? pose_b : pose_a;
    const float depth =
        fine.probe.depth_in(coarse.distance, relative(fine_pose, coarse_pose), floor);
    if (fine.probe_fills)
        return depth;
    return coarse.probe.depth_in(fine.distance, relative(coarse_pose, fine_pose), depth);
}

bool is_free(const Pile& pile, const Placed& a, const Placed& b, double overlap) {
    const PileComponent& ca = pile.component(a);
    const PileComponent& cb = pile.component(b);
    const auto floor = static_cast<float>(allowed_depth(ca, cb, overlap));
    return double(depth_between(ca, a.pose, cb, b.pose, floor)) <= double(floor);
}

Advance advance(const Pile& pile, const PileSite& site, double from, double limit, double overlap) {
    const PileComponent& component = pile.kinds[site.kind].component;
    std::vector<Neighbour> neighbours;
    const double middle = (from + limit) / 2;
    pile.hash.near(site.at(middle).pose.centre, component.reach + (limit - from) / 2,
                   [&](std::uint32_t index) {
                       neighbours.push_back({&pile.all[index], from});
                   });
    double height = from;
    for (std::size_t k = 0, unchanged = 0; unchanged < neighbours.size();
         k = (k + 1) % neighbours.size()) {
        Neighbour& neighbour = neighbours[k];
        ++unchanged;
        const PileComponent& other = pile.component(*neighbour.placed);
        const double allowed = allowed_depth(component, other, overlap);
        while (neighbour.free_until <= height) {
            const auto floor = static_cast<float>(height - limit + allowed);
            const auto depth = double(depth_between(component, site.at(height).pose, other,
                                                    neighbour.placed->pose, floor));
            if (depth <= allowed) {
                neighbour.free_until = height + std::max(allowed - depth, 1e-6 * component.radius);
                break;
            }
            height += std::max(depth - allowed, least_step * component.radius);
            unchanged = 0;
            if (height > limit)
                return {height, false};
        }
    }
    return {height, true};
}

} // namespace scree
