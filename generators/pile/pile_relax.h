// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/params.h"
#include "generators/pile/fill_solid.h"
#include "generators/pile/relax.h"

#include <optional>

namespace scree {

/// How generator.pile's parameters ask for relaxation, if they do. Throws Error, located, for a
/// target that is not closed, and for parameters of other methods.
std::optional<RelaxSettings> relax_settings(const Params& params);

/// Relaxes, notes where all began, and inserts what still finds room, at the sites and where the
/// surface shows. Returns how many were tried.
std::size_t place_relaxed(Pile& pile, Pile& start, const Mesh& target, const PileTurns& turns,
                          std::vector<PileSite> sites, const RelaxSettings& settings,
                          const std::optional<SolidFill>& solid, double cover,
                          const Context& context);

} // namespace scree
