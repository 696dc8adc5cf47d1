// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fabrication/distance_field.h"
#include "geometry/mesh/mesh.h"

#include <span>

namespace scree {

/// Unites the field with the solid inside a closed mesh whose corners are given in units of the
/// lattice: inside is where the surface winds round a point, whichever side is its front, and the
/// distance that to the nearest triangle. From any number of threads at once; the result depends on
/// neither their number nor the order of solids. False: there is no room for the field.
bool add_solid(DistanceField& field, std::span<const Imath::V3d> positions,
               std::span<const Mesh::Triangle> triangles);

} // namespace scree
