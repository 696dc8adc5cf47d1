// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generators/pile/pile_sites.h"
#include "geometry/bodies/insertion.h"

#include <limits>

namespace scree {

/// How a solid is filled.
struct SolidFill {
    // How many shells, counted from the surface, which is the first.
    std::size_t shells = std::numeric_limits<std::size_t>::max();
    double cover = 0; // of the surface, as in `pile_up`
};

/// The distance between the shells on which components are tried [m].
double shell_spacing(std::span<const PileKind> kinds);

/// The turns on an inner shell, which have a seed of its own.
PileTurns turns_of_shell(const PileTurns& turns, std::size_t shell);

/// Fills the closed target, on whose surface the `sites` are, with components: on offset shells,
/// each treated as a surface, from the innermost outwards, so that components come to lie on those
/// of the shells below. The centres of all components stay inside of the target, except for those
/// tried on its surface. Returns the number of components tried.
std::size_t fill_solid(PlacedBodies& pile, const Mesh& target, const PileTurns& turns,
                       std::vector<BodySite> sites, const SolidFill& fill,
                       const InsertionSettings& settings, const Context& context);

/// The share of the target's volume that is inside of components, estimated with 32768 points.
double filled_share(const PlacedBodies& pile, const Mesh& target, std::uint64_t seed);

} // namespace scree
