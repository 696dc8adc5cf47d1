// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/bodies/insertion.h"

#include <limits>

namespace scree {

/// What of a solid is filled.
struct SolidFill {
    std::size_t shells = std::numeric_limits<std::size_t>::max(); // the surface is the first
    double cover = 0;                                             // of the surface, as `pile_up`
};

/// How far apart the shells lie that components are tried on [m].
double shell_spacing(std::span<const PileKind> kinds);

/// Piles up components in the target, which is closed and has the `sites`: on offset shells, each
/// as on a surface, from the innermost outwards, so that every component comes to lie on those
/// below it. None of them but those of the surface itself leave it with their centres. Returns how
/// many were tried.
std::size_t fill_solid(Pile& pile, const Mesh& target, const PileTurns& turns,
                       std::vector<PileSite> sites, const SolidFill& fill,
                       const InsertionSettings& settings, const Context& context);

/// The share of the target's volume that is inside of components, from 32768 points.
double filled_share(const Pile& pile, const Mesh& target, std::uint64_t seed);

} // namespace scree
