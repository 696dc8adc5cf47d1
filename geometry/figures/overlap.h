// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/figures/collision_shape.h"

namespace scree {

/// Whether two regions overlap or are nearer than `clearance` [m] to each other; holes count as
/// outside. Conservative: where the answer is no, the regions are certainly apart; regions that are
/// apart by less than 1e-5 of the sum of their circumscribed radii may be said to overlap.
/// `a_from_b`: the position of a less that of b [m], which on a torus may be that of an image.
bool overlap(const CollisionShape& a, const FigurePose& pose_a, const CollisionShape& b,
             const FigurePose& pose_b, const Vec2& a_from_b, double clearance = 0);

} // namespace scree
