// SPDX-License-Identifier: GPL-3.0-or-later
// The methods of filling a domain. All share `Placements` and its overlap test.
#pragma once

#include "core/context.h"
#include "geometry/figures/placements.h"

namespace scree {

struct MethodCounts {
    std::uint64_t trials = 0;
    std::uint64_t cancellations = 0; // trials that found no room
    std::uint64_t queries = 0;       // pairs tested, in addition to those that Placements counted
};

/// Naive dart throwing (Sakurai & Miyata 2014, section 3.2): random place and rotation, cancelled
/// on overlap, until `cancellations` trials in a row were cancelled.
MethodCounts fill_naive(const LayoutProblem& problem, std::uint64_t cancellations,
                        Placements& placements, const Context& context);

/// What the saturated method proves.
struct Certificate {
    double epsilon = 0;          // nothing fits anywhere with this clearance [m]
    std::uint64_t cells = 0;     // intervals of angle and scale over an area, examined for it
    std::uint64_t undecided = 0; // areas where neither could be shown; 0 makes it a proof
    bool is_complete = false;    // not ended by a limit to the number of elements
    double seconds = 0;
};

struct SaturatedSettings {
    double epsilon = 0; // [m]
    double darts = 12;  // thrown for each element that the domain has area for, before the search
};

/// Fills the domain until no component of any kind fits anywhere, at any allowed angle and scale,
/// with the clearance epsilon: random darts first, then a search that looks at every place where
/// there may still be room. Throws Error for an epsilon that is too small.
MethodCounts fill_saturated(const LayoutProblem& problem, const SaturatedSettings& settings,
                            Placements& placements, Certificate& certificate,
                            const Context& context);

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
