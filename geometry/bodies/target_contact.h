// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/bodies/advance.h"

namespace scree {

/// Which components the surface of `target` comes within `tolerance` of, in radii of their largest
/// inner balls: its triangles are halved until a component's signed distance decides, give or take
/// 2% of its radius.
std::vector<char> touching_target(const Pile& pile, const Mesh& target, double tolerance);

} // namespace scree
