// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/params.h"
#include "model/aggregate.h"

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

} // namespace scree
