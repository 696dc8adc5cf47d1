// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/mesh/medial_balls.h"
#include "geometry/mesh/mesh.h"

namespace scree {

/// The largest of `balls` whose centre is inside the closed mesh, whichever side of its triangles
/// is the front; of radius 0 where there is none.
Ball largest_inside(const Mesh& mesh, std::vector<Ball> balls);

/// The largest ball inside a closed mesh that is found by climbing from `start`, whose centre is
/// inside: its centre moves wherever the surface is farther, by ever smaller steps.
Ball climb_to_largest(const Mesh& mesh, const Ball& start);

} // namespace scree
