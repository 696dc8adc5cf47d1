// SPDX-License-Identifier: GPL-3.0-or-later
// The methods of filling a domain. All share `Placements` and its overlap test.
#pragma once

#include "core/context.h"
#include "generators/layout/placements.h"

namespace scree {

struct MethodCounts {
    std::uint64_t trials = 0;
    std::uint64_t cancellations = 0; // trials that found no room
};

/// Naive dart throwing (Sakurai & Miyata 2014, section 3.2): random place and rotation, cancelled
/// on overlap, until `cancellations` trials in a row were cancelled.
MethodCounts fill_naive(const LayoutProblem& problem, std::uint64_t cancellations,
                        Placements& placements, const Context& context);

struct FillGapSettings {
    std::uint64_t cancellations = 200; // in a row, that end it (section 4)
    std::size_t candidates = 100;      // points tried per distance field
    std::uint32_t exponent = 16;       // of the normalised distance
    int resolution = 512;              // pixels of the distance field along the longest side
};

/// The fill-gap method (Sakurai & Miyata 2014, section 4): a sparse Poisson-disk start, then
/// elements preferably where the distance to all that is placed is large.
MethodCounts fill_gap(const LayoutProblem& problem, const FillGapSettings& settings,
                      Placements& placements, const Context& context);

} // namespace scree
