// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/mesh/mesh.h"
#include "geometry/plane/region.h"

namespace scree {

/// A flat body: the outline `rings` as seen from above (x to the right, the outline's second
/// coordinate away from the viewer: -z), from y = 0 to `height` [m], its edges rounded by a
/// quarter circle of radius `bevel` [m] in `bevel_segments` steps, cut down to what the outline and
/// the height allow. Closed, with normals; outline corners sharper than 30 degrees stay creases.
Mesh extrude(const std::vector<Ring>& rings, double height, double bevel, int bevel_segments = 5);

} // namespace scree
