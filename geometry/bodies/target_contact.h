// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/bodies/placed_bodies.h"

namespace scree {

/// Which of the bodies are within `tolerance` of the target's surface, in radii of their largest
/// inner balls, to within 2% of these radii. Triangles are halved until a body's signed distance
/// decides.
std::vector<char> touching_target(const PlacedBodies& bodies, const Mesh& target, double tolerance);

} // namespace scree
