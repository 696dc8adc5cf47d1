// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "shapes/mesh/loft.h"

#include <vector>

namespace scree {

/// A plane curve along which cross-sections are swept, given by its curvature.
class BentAxis {
  public:
    /// From the origin, starting towards +x, in the x-z plane; `curvature` [rad per length] at
    /// equal steps along `length`, turning towards +z.
    BentAxis(double length, const std::vector<double>& curvature);

    /// The section, points (side, up) counter-clockwise, stood across the axis at share `t` of its
    /// length.
    SpaceRing place(const Ring& section, double t) const;

  private:
    double length_;
    std::vector<Vec2> points_;    // (x, z)
    std::vector<double> heading_; // [rad]
};

/// Piecewise cubic through (x, y) knots of rising x that never overshoots (Fritsch & Carlson 1980).
double interpolate(const std::vector<Vec2>& knots, double x);

} // namespace scree
