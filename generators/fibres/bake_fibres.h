// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generators/fibres/fibres_settings.h"
#include "model/generator.h"

namespace scree::fibres {

/// Grows fibres, fits them into the target, brings them out of each other and to rest. Throws
/// Error (input) for a target that has no room for a fibre, Cancelled on the context's cancel.
Aggregate bake_fibres(const FibresSettings& settings, const Context& context);

} // namespace scree::fibres
