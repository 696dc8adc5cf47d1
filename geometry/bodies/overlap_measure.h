// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/bodies/advance.h"

namespace scree {

/// How much components overlap, measured with dense samples of the true meshes in the neighbours'
/// signed distance.
struct OverlapMeasure {
    std::size_t measured = 0; // components
    double mean_depth = 0;    // of the components' deepest, in radii of the smaller of a pair
    double percentile_99 = 0; // of them
    double largest_depth = 0;
    double volume_share = 0; // mean share of a component's volume that is inside others
};

/// Measures `most` components, or all, evenly taken from those placed; each against all others.
/// The volume's share is taken from `volume_samples` points inside each, none: not measured.
OverlapMeasure measure_overlap(const Pile& pile, std::size_t most, std::size_t volume_samples);

} // namespace scree
