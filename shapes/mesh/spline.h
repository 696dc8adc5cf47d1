// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/plane/region.h"

namespace scree {

/// A point of a curve and its tangent there (not normalised).
struct CurvePoint {
    Vec2 at;
    Vec2 tangent;
};

/// A smooth piece of a curve, including its two ends.
using CurvePiece = std::vector<CurvePoint>;

/// The centripetal Catmull-Rom spline through `points` in the half-plane x >= 0, with `steps` steps
/// from point to point. Unlike the natural cubic spline, it has no loops or cusps between two
/// points and a point influences only the four spans next to it (Yuksel, Schaefer & Keyser 2011). A
/// repeated point is a corner, at which a new piece begins. An open curve that ends on the line
/// x = 0 meets it at a right angle, so that its surface of revolution is smooth there. Needs at
/// least two different points, a closed curve three.
std::vector<CurvePiece> spline(const std::vector<Vec2>& points, bool closed, int steps);

/// The straight lines between the points, one piece each.
std::vector<CurvePiece> polyline(const std::vector<Vec2>& points, bool closed);

} // namespace scree
