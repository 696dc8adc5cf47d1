// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/plane/region.h"

namespace scree {

/// A point of a curve and the direction in which it goes on there (not of unit length).
struct CurvePoint {
    Vec2 at;
    Vec2 tangent;
};

/// A smooth stretch of a curve, its two ends included.
using CurvePiece = std::vector<CurvePoint>;

/// The centripetal Catmull-Rom spline through `points` in the half-plane x >= 0, `steps` steps from
/// point to point. It never makes a loop or a cusp between two points, and a point bends only the
/// four spans next to it (Yuksel, Schaefer & Keyser 2011), unlike the natural cubic spline. A point
/// written twice is a corner, at which a new piece begins. An open curve that ends on the line
/// x = 0 meets it at a right angle, so that a revolution is smooth there. At least two different
/// points; three of a closed one.
std::vector<CurvePiece> spline(const std::vector<Vec2>& points, bool closed, int steps);

/// The straight lines between the points, each a piece.
std::vector<CurvePiece> polyline(const std::vector<Vec2>& points, bool closed);

} // namespace scree
