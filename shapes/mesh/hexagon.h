// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapes/mesh/loft.h"

namespace scree {

/// The outline of a nut or bolt head about the y axis, its corners slightly rounded. A flat faces
/// angle 0.
struct Hexagon {
    std::vector<double> angles; // rising in [0, 2 pi)
    std::vector<double> radii;  // [m]

    explicit Hexagon(double across_flats);

    /// The outline where a chamfer meets the sides: a cone through the circle of radius `circle` at
    /// height `y`, falling by `slope` outwards (negative: rising, below a lower face).
    SpaceRing chamfered(double y, double circle, double slope) const;
};

} // namespace scree
