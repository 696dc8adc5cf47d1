// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/context.h"
#include "geometry/bodies/settle.h"

#include <span>

namespace scree {

/// How bodies are inserted.
struct InsertionSettings {
    double overlap = 0; // T, in radii of the smaller one's largest inner ball
    double sink = 0;    // how deep below the surface they begin, in radii of their own
    double ceiling = std::numeric_limits<double>::max(); // how high above it they may get [m]
    const Settler* settler = nullptr; // if any, lets them sink from where they came free
};

/// A site whose body is known to be blocked below `height`.
struct InsertionCandidate {
    BodySite site;
    double height = 0;  // above the site [m]
    double highest = 0; // the greatest height at which it is tried [m]
    bool placed = false;
    PlacedBody at{}; // where it is once placed
};

/// What is to be inserted at these sites, as low as the settings allow. `ranges`: how far outwards
/// each of the bodies may move [m].
std::vector<InsertionCandidate> candidates_at(std::vector<BodySite> sites, const Bodies& bodies,
                                              std::span<const double> ranges,
                                              const InsertionSettings& settings);

/// Inserts the candidates in their order: each moves outwards to the first height at which it is
/// free of all placed before it, but no higher than `level` radii of its own, and then settles.
/// Candidates that find no room stay in the list for a higher level, unless they are above their
/// `highest`; those placed leave it. The outcome does not depend on the number of threads.
void insert_up_to(double level, PlacedBodies& bodies, std::vector<InsertionCandidate>& candidates,
                  const InsertionSettings& settings, const Context& context);

} // namespace scree
