// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/figures/collision_shape.h"

namespace scree {

/// Whether two regions overlap or are nearer than `clearance` [m] to each other, holes counting as
/// outside; in doubt, yes. Where the answer is no, the regions are truly apart, by exact predicates
/// on their vertices as double arithmetic gives them. The doubt is at most 1e-5 of the sum of their
/// circumscribed radii. `a_from_b`: the position of a less that of b [m]; not always the difference
/// of the poses, where space wraps round.
bool overlap(const CollisionShape& a, const Pose& pose_a, const CollisionShape& b,
             const Pose& pose_b, const Vec2& a_from_b, double clearance = 0);

} // namespace scree
