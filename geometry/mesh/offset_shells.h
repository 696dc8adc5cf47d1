// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces inside of a solid, each at a constant depth.
#pragma once

#include "geometry/mesh/signed_distance_grid.h"

namespace scree {

/// The surface where the distance is `level` [m], which is less than at the grid's border: a plane
/// cuts each of the six tetrahedra of each cube of samples (Kuhn 1960). It is closed, with
/// distances below the level inside; empty where no sample is below.
Mesh level_surface(const SignedDistanceGrid& distance, double level);

/// A surface inside of a solid.
struct OffsetShell {
    double depth = 0; // [m]
    Mesh surface;
};

/// Surfaces `spacing` [m] apart below that of a solid, itself not among them, until there is no
/// inside left; at most `most`.
std::vector<OffsetShell> offset_shells(const SignedDistanceGrid& solid, double spacing,
                                       std::size_t most);

} // namespace scree
