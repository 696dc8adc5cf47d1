// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/placed_regions.h"

namespace scree {

/// Area of the intersection of two polygons with holes [m^2], exact up to rounding; time grows
/// with the product of their edges' numbers. Touching and shared edges do no harm.
double intersection_area(const Region& a, const Region& b);

/// Area of the window that the regions cover, which must not overlap [m^2]: of a region that
/// sticks out of the domain only the part inside counts; on a torus all counts.
double covered_area(const PlacedRegions& regions);

} // namespace scree
