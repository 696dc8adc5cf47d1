// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/placed_regions.h"

namespace scree {

/// Area of the intersection of two polygons with holes [m^2], exact up to rounding, also for
/// touching and shared edges. The time is proportional to the product of the numbers of edges.
double intersection_area(const Region& a, const Region& b);

/// Area of the window that is covered by the regions [m^2], which must not overlap. Only the parts
/// inside the domain count, except on a torus, where the regions count in full.
double covered_area(const PlacedRegions& regions);

} // namespace scree
