// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/context.h"
#include "generators/pile/pile_kind.h"
#include "geometry/bodies/placed_bodies.h"

#include <optional>

namespace scree {

/// The parameters of Sakurai's method (2013, chapter 4).
struct ThesisSettings {
    double overlap = 0;            // T, in radii of the component's largest inner ball
    std::optional<double> removal; // D, likewise; nothing: no component is removed
};

/// The sites, in their order, without those that lie within the distribution radius of a larger
/// component's site (section 4.3.1.5).
std::vector<BodySite> merge_large_to_small(std::span<const PileKind> kinds,
                                           std::span<const BodySite> sites);

/// Places components at all sites. Each in turn moves outwards to where the cost of overlap and
/// height is least (eq. 4.1; section 4.3.2), found by golden-section search, while the others stay.
/// Overlap is that of eq. 4.2: of vertices in the neighbours' medial balls. With `removal`, each
/// component in turn is then removed if it still overlaps those left by more than that. (Eq. 4.3 is
/// printed as "cost < D", which would remove the best; the text, by which with D = 0 each component
/// touches others, shows what is meant.) The outcome does not depend on the number of threads.
void place_by_thesis(PlacedBodies& pile, std::span<const PileKind> kinds,
                     std::span<const BodySite> sites, const ThesisSettings& settings,
                     const Context& context);

} // namespace scree
