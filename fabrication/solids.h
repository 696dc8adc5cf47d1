// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/aggregate.h"

#include <span>

namespace scree {

/// An instance of a closed mesh.
struct Solid {
    const Mesh* mesh = nullptr;
    WideMatrix world_from_object;
};

/// All instances of closed components.
std::vector<Solid> closed_solids(std::span<const Aggregate> aggregates);

/// The smallest thickness of the solids [m]: the shortest side of the mesh's bounding box in object
/// space times the scale. Infinite when there are none.
double thinnest(std::span<const Solid> solids);

/// The largest absolute coordinate of the solids [m].
double farthest(std::span<const Solid> solids);

} // namespace scree
