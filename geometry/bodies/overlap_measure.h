// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/bodies/placed_bodies.h"

namespace scree {

/// How much bodies overlap, measured with dense samples of the meshes themselves in the others'
/// signed distances. A body's depth is that of its deepest contact, in radii of the smaller one's
/// largest inner ball.
struct OverlapMeasure {
    std::size_t measured = 0; // how many bodies
    double mean_depth = 0;
    double percentile_99 = 0; // of the depths
    double largest_depth = 0;
    double volume_share = 0; // mean share of a body's volume that is inside others
};

/// Measures at most `most` of the bodies, evenly taken from all, each against all others. The share
/// of the volume is estimated with `volume_samples` points inside of each body; 0: not at all.
OverlapMeasure measure_overlap(const PlacedBodies& bodies, std::size_t most,
                               std::size_t volume_samples);

} // namespace scree
