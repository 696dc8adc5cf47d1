// SPDX-License-Identifier: GPL-3.0-or-later
// What the methods that make rocks of cells have in common.
#pragma once

#include "core/context.h"
#include "generators/rocks/rocks_settings.h"
#include "geometry/plane/power_diagram.h"
#include "model/aggregate.h"

namespace scree::rocks {

/// The domain's outline, counter-clockwise. Throws Error, located, where it is not convex.
Ring convex_outline(const RocksSettings& settings);

/// An aggregate of rocks of which each has a shape of its own, in the scene's frame.
/// @param kinds of each mesh, which of the generator's materials is its, in turn
Aggregate aggregate_of(std::vector<Mesh> meshes, std::span<const std::size_t> kinds,
                       const RocksSettings& settings);

} // namespace scree::rocks
