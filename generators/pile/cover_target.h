// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generators/pile/pile_cover.h"
#include "generators/pile/pile_sites.h"
#include "geometry/bodies/insertion.h"

namespace scree {

/// How `pile_up` ended.
struct PileUp {
    std::size_t tried = 0; // components
    bool covered = false;  // certain that as much is hidden as was asked for
};

/// Inserts components at the sites, level by level from the surface outwards. With `cover` > 0 each
/// level is also filled where the target's surface can still be seen, before the next begins, and
/// the pile is done as soon as the share `cover` of the surface is hidden from outside.
PileUp pile_up(PlacedBodies& pile, const Mesh& target, const PileTurns& turns,
               std::vector<BodySite> sites, const InsertionSettings& settings, double cover,
               const Context& context);

/// The share of the target's surface that is hidden from outside, estimated with 8192 rays that are
/// independent of those of `pile_up`; the standard error is 0.1% at a share of 99%.
double measured_cover(const PlacedBodies& pile, const Mesh& target, std::uint64_t seed);

} // namespace scree
