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

    /// The curve in which a chamfer's cone meets the sides. The cone passes through the circle of
    /// radius `circle` at height `y` and falls outwards by `slope` (negative: rises, for a lower
    /// face).
    SpaceRing chamfered(double y, double circle, double slope) const;
};

} // namespace scree
