// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/params.h"
#include "core/random.h"
#include "procedurals/solid/marble/marble_as_cpp.h"
#include "procedurals/solid/marble/marble_presets.h"

namespace scree {

/// Fills the layer with veins of uneven widths at uneven distances, which repeat after `size` [m].
void scatter_veins(solid::VeinLayer& layer, const MarbleVeins& veins, double size, Random& random);

/// Fills it with those of the parameter `veins`, which stand there once, as in the paper; what one
/// leaves out is that of `defaults`. Throws Error when there are too many.
void list_veins(solid::VeinLayer& layer, const Params& params, const MarbleVeins& defaults);

/// Fills the finished layer's table of filtered profiles.
void tabulate(solid::VeinLayer& layer);

} // namespace scree
