// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generators/rocks/ground.h"
#include "generators/rocks/rock_surface.h"
#include "model/aggregate.h"

namespace scree::rocks {

/// Adds how deep rocks are in others and how far they are from the nearest thing below, measured at
/// `most` of them, evenly taken from all, with the true distances of the meshes' vertices; in
/// longest axes of the smaller rock.
void add_measures(std::span<const PlacedRock> rocks, std::span<const RockSurface> surfaces,
                  const Ground& ground, std::size_t most, Facts& facts);

} // namespace scree::rocks
