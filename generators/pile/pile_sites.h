// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/context.h"
#include "generators/pile/orientation_flow.h"
#include "generators/pile/pile_kind.h"
#include "geometry/bodies/placed_bodies.h"

namespace scree {

/// The frame that components are turned in: v along the surface's normal and u along its level line
/// or a flow, or the axes of the target.
enum class PileFrame { surface, global };

/// How components are turned at their sites.
struct PileTurns {
    std::span<const PileKind> kinds;
    PileFrame frame = PileFrame::surface;
    const OrientationFlow* flow = nullptr; // if any, what u follows in the surface's frame
    std::uint64_t seed = 0;

    /// A site whose random rotation and, of a component with several shapes, random shape are those
    /// of `number`.
    BodySite site(const Imath::V3d& position, const Vec3& normal, std::uint32_t kind,
                  std::uint64_t number) const;
};

/// A maximal set of sites for each component, two distribution radii apart, in the order in which
/// they are to be tried: random within a component, and each component as often as its weight says
/// for as long as it has sites left. Throws as `sample_surface_disks`.
std::vector<BodySite> pile_sites(const Mesh& target, const PileTurns& turns,
                                 const Context& context);

} // namespace scree
