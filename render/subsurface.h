// SPDX-License-Identifier: GPL-3.0-or-later
// Light under the surface of a translucent object: a random walk through a medium that scatters
// equally in all directions, from where the light enters to where it leaves.
#pragma once

#include "core/random.h"
#include "render/bsdf/medium.h"
#include "render/world/world.h"

namespace scree {

/// How a walk ended.
struct Walk {
    RawHit exit;            // on the same instance; none: it leaves where it entered
    Vec3 direction;         // in which it reached the exit
    Vec3 origin;            // exit.distance before it
    Color weight;           // the share of the light that is left; black: absorbed
    std::uint64_t rays = 0; // traced during the walk
};

/// Follows light of `throughput` (not black) that enters at `entry` along `direction`. `choice`,
/// uniform in [0, 1), chooses the channel whose free paths are sampled; all are weighted by the
/// balance heuristic (Veach & Guibas 1995; Chiang, Burley & Tappan 2016, "Practical and
/// controllable subsurface scattering for production path tracing").
///
/// A mesh of overlapping closed parts counts as their union. Light that leaves the mesh's bounding
/// box through a hole comes out where it entered, with the medium's color: an open mesh is opaque.
/// Light that has taken thousands of steps comes out where it entered, too, with what is left of
/// it.
Walk walk_inside(const World& world, const Medium& medium, const Hit& entry, const Vec3& direction,
                 const Color& throughput, float choice, Random& random,
                 std::uint64_t* clock = nullptr);

} // namespace scree
