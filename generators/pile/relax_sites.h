// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generators/pile/relax.h"
#include "geometry/bodies/mass_properties.h"

namespace scree {

/// Where relaxation starts: components at random places and with random rotations, evenly through
/// the space that the settings ask for. `distance` is the target's, `masses` are those of the
/// kinds.
std::vector<PlacedBody> strewn(const Mesh& target, const SignedDistanceGrid& distance,
                               const PileTurns& turns, std::span<const MassProperties> masses,
                               const RelaxSettings& settings, const Context& context);

} // namespace scree
