// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/context.h"
#include "geometry/bodies/settle.h"

namespace scree {

/// How components are inserted.
struct InsertionSettings {
    double overlap = 0; // T, in radii of the largest inner ball
    double sink = 0;    // how deep below the surface they begin, in such radii
    double ceiling = std::numeric_limits<double>::max(); // how far above it they may get [m]
    const Settler* settler = nullptr;                    // lets them sink from where they came free
};

/// A site whose component is blocked below `height` [m].
struct InsertionCandidate {
    PileSite site;
    double height = 0;
    bool placed = false;
    Placed at{}; // where it is once placed
};

/// What is to be inserted, at its lowest.
std::vector<InsertionCandidate> candidates_at(std::vector<PileSite> sites,
                                              std::span<const PileKind> kinds,
                                              const InsertionSettings& settings);

/// Inserts the candidates in their order: each moves outwards to the first height at which it is
/// free of those before it, not beyond `level` radii of its largest inner ball and its kind's
/// range, and settles. Those that find no room stay for a higher level; those that never will, and
/// those placed, go. The outcome does not depend on the number of threads.
void insert_up_to(double level, Pile& pile, std::vector<InsertionCandidate>& candidates,
                  const InsertionSettings& settings, const Context& context);

} // namespace scree
