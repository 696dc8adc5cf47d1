// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generators/pile/pile_sites.h"

namespace scree {

/// How components are relaxed.
struct RelaxSettings {
    bool solid = false;   // through the target's volume instead of near its surface
    double density = 0.5; // share of that space that the components would fill without overlaps
    int iterations = 60;  // sweeps over all pairs, at most
    double overlap = 0;   // T, in radii of the smaller one's largest inner ball
};

/// What relaxation makes of components.
struct Relaxed {
    std::vector<PlacedBody> start; // as strewn, overlapping
    std::vector<PlacedBody>
        all; // those left, no two deeper in each other than T and 2% of a radius
};

/// Strews components of all kinds, as often as their weights say, over the closed target's surface
/// and up to their ranges above it, or through its volume, and pushes them apart with all six
/// degrees of freedom, while their centres are kept in that space. Each Gauss-Seidel sweep goes
/// through the pairs colour by colour; no two pairs of a colour share a component. In the end
/// components that are still too deep in others are removed. The outcome does not depend on the
/// number of threads.
Relaxed relax(const Mesh& target, const PileTurns& turns, const RelaxSettings& settings,
              const Context& context);

} // namespace scree
