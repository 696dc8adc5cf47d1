// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/context.h"
#include "geometry/bodies/advance.h"

#include <optional>

namespace scree {

/// How Sakurai's method (2013, chapter 4) refines.
struct ThesisSettings {
    double overlap = 0;            // T, in radii of the component's largest inner ball
    std::optional<double> removal; // D, in such radii
};

/// Sites less those of smaller components that lie within the distribution radius of a larger one
/// (section 4.3.1.5), in the same order.
std::vector<PileSite> merge_large_to_small(std::span<const PileKind> kinds,
                                           std::span<const PileSite> sites);

/// Components at all sites; each in turn moves outwards to where eq. 4.1's cost of overlap and
/// height is least (section 4.3.2), found by golden-section search, while the others stay. Overlap
/// is what eq. 4.2 sees: vertices in the neighbours' medial balls. With `removal`, those then go,
/// in order, that still overlap what is left by more. (Eq. 4.3 prints "cost < D", which would take
/// away the best; the text's "each touches others" for D = 0 tells what is meant.) The outcome does
/// not depend on the number of threads.
void place_by_thesis(Pile& pile, std::span<const PileSite> sites, const ThesisSettings& settings,
                     const Context& context);

} // namespace scree
