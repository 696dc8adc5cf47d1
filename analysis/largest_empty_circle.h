// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/region_distance.h"

namespace scree {

struct Circle {
    Vec2 centre;
    double radius = 0; // [m]
};

/// The largest circle in the window that meets no region, by branch and bound over squares on the
/// distance to the nearest region or to the domain's border (on a torus there is none): no empty
/// circle is larger by more than the share `tolerance` of its radius. Radius 0 when there is no
/// room at all.
Circle largest_empty_circle(const PlacedRegions& regions, const RegionDistance& distance,
                            double tolerance = 1e-4);

} // namespace scree
