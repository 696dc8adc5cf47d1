// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapes/mesh/loft.h"

#include <vector>

namespace scree {

/// A plane curve, given by its curvature, along which cross-sections are swept.
class BentAxis {
  public:
    /// A curve in the x-z plane that starts at the origin towards +x. `curvature` [rad per length]
    /// holds values at equal steps along `length`; positive ones turn towards +z.
    BentAxis(double length, const std::vector<double>& curvature);

    /// The cross-section, counter-clockwise points (side, up), placed perpendicular to the axis at
    /// share `t` of its length.
    SpaceRing place(const Ring& section, double t) const;

  private:
    double length_;
    std::vector<Vec2> points_;    // (x, z)
    std::vector<double> heading_; // [rad]
};

/// Monotone piecewise cubic interpolation of (x, y) knots of rising x (Fritsch & Carlson 1980).
double interpolate(const std::vector<Vec2>& knots, double x);

} // namespace scree
