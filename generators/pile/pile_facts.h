// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generators/pile/pile_kind.h"
#include "geometry/bodies/placed_bodies.h"
#include "model/aggregate.h"

namespace scree {

/// Adds how many there are of each component, if there are several.
void add_counts(const PlacedBodies& pile, std::span<const PileKind> kinds, Facts& facts);

/// The pile with all components moved back to their sites.
PlacedBodies at_their_sites(const PlacedBodies& pile);

/// Adds how deep components are in each other, in the finished pile and in that they `start`ed
/// from, measured at `most` of them.
void add_overlap(const PlacedBodies& pile, const PlacedBodies& start, std::size_t most,
                 Facts& facts);

} // namespace scree
