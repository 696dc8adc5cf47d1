// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generators/pile/relax.h"
#include "geometry/bodies/mass_properties.h"

namespace scree {

/// Where relaxation starts: components at random, evenly through the space that the settings name.
std::vector<Placed> strewn(const Mesh& target, const SignedDistanceGrid& distance,
                           const PileTurns& turns, std::span<const MassProperties> masses,
                           const RelaxSettings& settings, const Context& context);

} // namespace scree
