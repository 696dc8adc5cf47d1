// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/aggregate.h"
#include "core/params.h"

namespace scree {

/// The components as prototypes with their exclusive regions.
struct Components {
    std::vector<Prototype> prototypes;
    std::vector<double> bare_areas; // of the regions without margin, at scale 1 [m^2]
};

enum class Margins {
    in_regions, // the exclusive regions are grown or shrunk by them
    by_place    // they are kept apart from them, since they vary
};

/// Reads shape, region, margin and material of each component. Throws Error, located, for a mesh
/// without a silhouette, a margin that leaves nothing, and one below 0 that is to vary.
Components components_from(const std::vector<Params>& components, Margins margins);

/// Takes `centre` of a component's x-z plane to the origin, scales, turns from +x towards +z, moves
/// to `position` and lifts by `height` [m]; y = 0 stays the ground.
Matrix world_from_component(const Vec2& centre, const Vec2& position, double angle, double scale,
                            double height);

} // namespace scree
