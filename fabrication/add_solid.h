// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fabrication/distance_field.h"
#include "geometry/mesh/mesh.h"

#include <span>

namespace scree {

/// Unites the field with the solid inside a closed mesh, given in units of the lattice. A point is
/// inside if its winding number is not 0, whatever the orientation of the mesh; the distance is
/// that to the nearest triangle. Thread-safe; the result depends neither on the number of threads
/// nor on the order of solids. False when the field needs too much memory.
bool add_solid(DistanceField& field, std::span<const Imath::V3d> positions,
               std::span<const Mesh::Triangle> triangles);

} // namespace scree
