// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

#include <span>
#include <vector>

namespace scree {

/// The corners of the points' convex hull, anticlockwise (Andrew 1979); of points in a line its
/// ends.
std::vector<Vec2> convex_hull(std::vector<Vec2> points);

/// Whether `point` is in the convex hull of `points`, or not farther than `tolerance` from it.
bool in_convex_hull(const Vec2& point, std::vector<Vec2> points, double tolerance);

} // namespace scree
