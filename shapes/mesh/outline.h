// SPDX-License-Identifier: GPL-3.0-or-later
// Plane curves from which components are extruded and revolved.
#pragma once

#include "geometry/plane/region.h"

namespace scree {

/// A corner of an outline and its rounding radius.
struct Corner {
    double x = 0;
    double y = 0;
    double radius = 0;
};

/// The ring through `corners` with every corner rounded by an arc of about `quarter` segments per
/// quarter turn. A radius that is too large for the adjacent edges is reduced.
Ring round_corners(const std::vector<Corner>& corners, int quarter);

/// The same for an open curve, whose two ends are not rounded.
Ring round_curve(const std::vector<Corner>& corners, int quarter);

/// A regular polygon with `segments` corners, counter-clockwise from angle 0.
Ring circle(double radius, int segments, const Vec2& center = Vec2(0.0));

/// Points of an arc from angle `begin` to `end` [rad], both included.
Ring arc(const Vec2& center, double radius, double begin, double end, int segments);

/// Moves every edge to its left by `distance`: inwards for a counter-clockwise ring, outwards for
/// the clockwise ring of a hole. Corners move along their mitres.
Ring inset(const Ring& ring, double distance);

/// The largest distance for which no edge of inset(ring, distance) is reversed.
double largest_inset(const Ring& ring);

} // namespace scree
