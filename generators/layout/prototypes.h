// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generators/layout/layout_settings.h"
#include "model/aggregate.h"

namespace scree {

/// The components as prototypes with their exclusive regions.
struct Components {
    std::vector<Prototype> prototypes;
    std::vector<double> bare_areas; // of the regions without margin, at scale 1 [m^2]
};

enum class Margins {
    in_regions, // the exclusive regions are grown or shrunk by their margins
    by_place    // the margins vary with the place, so that the regions are kept apart by them
};

/// Throws Error, located, for a mesh without a silhouette, a region without area, a margin that
/// leaves nothing, and one below 0 that is to vary.
Components components_from(const std::vector<LayoutComponent>& components, Margins margins);

} // namespace scree
