// SPDX-License-Identifier: GPL-3.0-or-later
// Conservative advancement: a signed distance changes no faster than the point moves, so a body
// that reaches `depth` into another has to move at least that far, in whatever direction, to be
// free.
#pragma once

#include "geometry/bodies/placed_bodies.h"

#include <limits>

namespace scree {

/// How deep two bodies reach into each other [m], by their probes, to within 1% of the smaller
/// radius; negative where they are apart. `floor` and `enough` as in `BallTree::depth_in`.
float depth_between(const Body& a, const Pose& pose_a, const Body& b, const Pose& pose_b,
                    float floor, float enough = std::numeric_limits<float>::max());

/// How deep two bodies may reach into each other and still count as free [m]. `overlap` is in radii
/// of the smaller one's largest inner ball.
double allowed_depth(const Body& a, const Body& b, double overlap);

/// Whether two placed bodies reach no deeper into each other than `allowed_depth`.
bool is_free(const PlacedBodies& bodies, const PlacedBody& a, const PlacedBody& b, double overlap);

/// Where a body that moves outwards is free of others.
struct Advance {
    double height = 0; // above the site [m]; beyond the limit if it is not free below it
    bool free = false;
};

/// Moves the site's body outwards from the height `from` [m] to the first one at which it reaches
/// no deeper into any of `bodies` than `allowed_depth`, to within 2% of its radius; not beyond the
/// height `limit` [m].
Advance advance(const PlacedBodies& bodies, const BodySite& site, double from, double limit,
                double overlap);

} // namespace scree
