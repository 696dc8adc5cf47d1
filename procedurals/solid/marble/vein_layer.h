// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/params.h"
#include "core/random.h"
#include "procedurals/solid/marble/marble_as_cpp.h"
#include "procedurals/solid/marble/marble_presets.h"

namespace scree {

/// Fills the layer with random veins of varying widths and distances, with the period `size` [m].
void scatter_veins(solid::VeinLayer& layer, const MarbleVeins& veins, double size, Random& random);

/// Fills the layer with the veins of the parameter `veins`, which are not periodic, as in the
/// paper. `defaults` gives parameters that are not set. Throws Error when there are too many.
void list_veins(solid::VeinLayer& layer, const Params& params, const MarbleVeins& defaults);

/// Computes the table of filtered profiles; called when the layer is complete.
void tabulate(solid::VeinLayer& layer);

} // namespace scree
