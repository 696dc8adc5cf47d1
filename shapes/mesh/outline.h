// SPDX-License-Identifier: GPL-3.0-or-later
// Plane curves that components are revolved and extruded from.
#pragma once

#include "geometry/plane/region.h"

namespace scree {

/// A corner of an outline and the radius that rounds it.
struct Corner {
    double x = 0;
    double y = 0;
    double radius = 0;
};

/// The ring through `corners` with every corner rounded by an arc of about `quarter` segments per
/// quarter turn. A radius too large for its edges is cut down to what fits.
Ring round_corners(const std::vector<Corner>& corners, int quarter);

/// The same for an open curve: the two ends stay.
Ring round_curve(const std::vector<Corner>& corners, int quarter);

/// A regular polygon of `segments` corners, counter-clockwise from angle 0.
Ring circle(double radius, int segments, const Vec2& center = Vec2(0.0));

/// Points of an arc from angle `begin` to `end` [rad], both included.
Ring arc(const Vec2& center, double radius, double begin, double end, int segments);

/// Every corner moved along its mitre so that each edge lies `distance` to its left: into the
/// polygon for a counter-clockwise ring, out of it for a hole.
Ring inset(const Ring& ring, double distance);

/// The largest distance for which no edge of inset(ring, distance) has turned round.
double largest_inset(const Ring& ring);

} // namespace scree
