// SPDX-License-Identifier: GPL-3.0-or-later
// Conservative advancement: a signed distance is 1-Lipschitz, so that what reaches `depth` into
// another is not free of it before it has moved that far, whichever way.
#pragma once

#include "generators/pile/pile_sites.h"
#include "geometry/bodies/neighbour_hash.h"

namespace scree {

/// What is placed so far, and where.
struct Pile {
    explicit Pile(std::span<const PileKind> kinds_of) : kinds(kinds_of), hash(kinds_of) {}

    void add(const Placed& placed) {
        hash.add(placed.kind, static_cast<std::uint32_t>(all.size()), placed.pose.centre);
        all.push_back(placed);
    }
    const PileComponent& component(const Placed& placed) const {
        return kinds[placed.kind].component;
    }

    std::span<const PileKind> kinds;
    std::vector<Placed> all;
    NeighbourHash hash;
};

/// How far two components reach into each other [m], as their probes tell, give or take 1% of the
/// smaller radius; negative where they are apart. `floor` and `enough` as in `BallTree::depth_in`.
float depth_between(const PileComponent& a, const Pose& pose_a, const PileComponent& b,
                    const Pose& pose_b, float floor,
                    float enough = std::numeric_limits<float>::max());

/// How deep two components may reach into each other and still count as free [m], for `overlap` in
/// radii of the smaller's largest inner ball.
double allowed_depth(const PileComponent& a, const PileComponent& b, double overlap);

/// Whether two components reach no deeper than `overlap` (in radii of the smaller's largest inner
/// ball) into each other.
bool is_free(const Pile& pile, const Placed& a, const Placed& b, double overlap);

/// Where a component comes free.
struct Advance {
    double height = 0; // [m] outwards; beyond the limit where it is not free
    bool free = false;
};

/// Moves the site's component outwards from `from` [m] to the first height at which it reaches no
/// deeper than `overlap` (in radii of the largest inner ball) into any of the pile, give or take 2%
/// of its radius; not beyond `limit` [m].
Advance advance(const Pile& pile, const PileSite& site, double from, double limit, double overlap);

} // namespace scree
