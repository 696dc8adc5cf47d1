// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generators/layout/collision_shape.h"

namespace scree {

/// Whether two regions overlap, holes counting as outside; in doubt, yes. Where the answer is no,
/// the regions are truly apart, by exact predicates on their vertices as double arithmetic gives
/// them. They may be called overlapping when they are less than 2e-5 of the sum of their
/// circumscribed radii apart. `a_from_b`: the position of a less that of b [m], which is more than
/// the difference of the poses where space wraps round.
bool overlap(const CollisionShape& a, const Pose& pose_a, const CollisionShape& b,
             const Pose& pose_b, const Vec2& a_from_b);

} // namespace scree
