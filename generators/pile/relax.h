// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/bodies/insertion.h"

namespace scree {

/// How components are relaxed.
struct RelaxSettings {
    bool solid = false;   // in the target's volume, or near its surface
    double density = 0.5; // share of that space that they would fill at the start, less overlaps
    int iterations = 60;
    double overlap = 0; // T, in radii of the largest inner ball
};

struct Relaxed {
    std::vector<Placed> start; // where they began, on top of each other
    std::vector<Placed> all;   // those left, no two deeper than T and 2% of a radius
};

/// Components of all kinds at once, by their weights, strewn over the closed target's surface, up
/// to their range above it, or through its volume, are pushed apart with all six degrees of
/// freedom, while their centres are held where they were strewn: Gauss-Seidel sweeps over pairs in
/// colours, none of which has a body twice. Then the worst of those still too deep go. The outcome
/// does not depend on the number of threads.
Relaxed relax(const Mesh& target, const PileTurns& turns, const RelaxSettings& settings,
              const Context& context);

} // namespace scree
