// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/mesh/mesh.h"
#include "geometry/plane/region.h"

namespace scree {

/// Extrudes the outline `rings`, given as seen from above (first coordinate x, second -z), from
/// y = 0 to `height` [m]. Its edges are rounded by quarter circles of radius `bevel` [m] in
/// `bevel_segments` steps; the radius is reduced to what the outline and the height allow. The mesh
/// is closed and has normals; corners of the outline sharper than 30 degrees stay creases.
Mesh extrude(const std::vector<Ring>& rings, double height, double bevel, int bevel_segments = 5);

} // namespace scree
