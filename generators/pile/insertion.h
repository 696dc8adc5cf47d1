// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/context.h"
#include "generators/pile/advance.h"

namespace scree {

/// How components are inserted.
struct InsertionSettings {
    double overlap = 0; // T, in radii of the largest inner ball
    double sink = 0;    // how deep below the surface they begin, in such radii
};

/// Inserts components at their sites, in layers from the surface outwards and in the sites' order
/// within each: each goes to the lowest height, from `sink` below the surface to its kind's range
/// above it, at which it is free of those before it. What finds no room there is left out. The
/// outcome does not depend on the number of threads.
void insert_components(Pile& pile, std::span<const PileSite> sites,
                       const InsertionSettings& settings, const Context& context);

} // namespace scree
