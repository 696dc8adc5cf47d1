// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/context.h"
#include "generators/pile/orientation_flow.h"
#include "geometry/bodies/pile_kind.h"

#include <span>

namespace scree {

/// A place on the target's surface at which a component is tried, with its turn.
struct PileSite {
    Imath::V3d position;
    Vec3 normal;                      // of the surface, outwards, of length 1
    Imath::M33f world_from_component; // the component's turn there
    std::uint32_t kind = 0;

    /// The component moved outwards by `height` [m].
    Placed at(double height) const {
        return {
            kind, {position + Imath::V3d(normal) * height, world_from_component}, normal, height};
    }
};

/// What the components' v axes point along before they are turned at random: the surface's normal,
/// or the world's y axis.
enum class PileFrame { surface, global };

/// How sites are turned and numbered.
struct PileTurns {
    std::span<const PileKind> kinds;
    PileFrame frame = PileFrame::surface;
    const OrientationFlow* flow = nullptr; // of u, in place of the frame
    std::uint64_t seed = 0;

    /// A site with its random turn and, of the kind, shape, which are those of `number`.
    PileSite site(const Imath::V3d& position, const Vec3& normal, std::uint32_t kind,
                  std::uint64_t number) const;
};

/// A maximal set of sites for each kind, two of its distribution radii apart, in the order in which
/// they are tried: random within a kind, and every kind as often as its weight says while it has
/// sites left. Throws as `sample_surface_disks`.
std::vector<PileSite> pile_sites(const Mesh& target, const PileTurns& turns,
                                 const Context& context);

} // namespace scree
