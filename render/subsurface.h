// SPDX-License-Identifier: GPL-3.0-or-later
// Light under the surface of a translucent thing: a random walk through a medium that scatters
// alike in all directions, from where the light comes in to where it goes out.
#pragma once

#include "core/random.h"
#include "render/bsdf/medium.h"
#include "render/world/world.h"

namespace scree {

/// How a walk ended.
struct Walk {
    RawHit exit;            // on the same instance; none: out where it came in
    Vec3 direction;         // in which it reached the exit
    Color weight;           // what is left of what came in; black: absorbed
    std::uint64_t rays = 0; // traced on the way
};

/// Follows light of `throughput` (not black) that goes in at `entry` along `direction`. `choice`,
/// uniform in [0, 1), chooses the channel whose free paths are sampled; all are weighted by the
/// balance heuristic (Veach & Guibas 1995; Chiang, Burley & Tappan 2016, "Practical and
/// controllable subsurface scattering for production path tracing").
///
/// A mesh of overlapping closed parts is their union. Light that strays out of the mesh's box
/// through a hole goes out where it came in, with the medium's color: an open mesh is opaque. So
/// does light that has gone thousands of steps, with what is left of it.
Walk walk_inside(const World& world, const Medium& medium, const Hit& entry, const Vec3& direction,
                 const Color& throughput, float choice, Random& random,
                 std::uint64_t* clock = nullptr);

} // namespace scree
