// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/aggregate.h"

#include <span>

namespace scree {

/// A closed mesh where it stands in the world.
struct Solid {
    const Mesh* mesh = nullptr;
    Matrix world_from_object;
};

/// All instances of closed components.
std::vector<Solid> closed_solids(std::span<const Aggregate> aggregates);

/// The smallest of all solids' thicknesses, each the shortest side of its mesh's bounding box in
/// its own frame times its scale [m]; infinite when there is none.
double thinnest(std::span<const Solid> solids);

/// The largest coordinate of any, either way [m].
double farthest(std::span<const Solid> solids);

} // namespace scree
