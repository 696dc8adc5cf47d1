// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/region_distance.h"

namespace scree {

struct Circle {
    Vec2 centre;
    double radius = 0; // [m]
};

/// The largest circle in the window that meets no region, found by branch and bound over squares.
/// The bounded quantity is the distance to the nearest region or to the domain's border (a torus
/// has no border). The radius is within the relative `tolerance` of the optimum; it is 0 when there
/// is no free space.
Circle largest_empty_circle(const PlacedRegions& regions, const RegionDistance& distance,
                            double tolerance = 1e-4);

} // namespace scree
