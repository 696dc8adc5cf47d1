// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/region_distance.h"

namespace scree {

/// Distances to the nearest region [m] from points of the free space, the part of the window that
/// no region covers.
struct GapSamples {
    std::size_t in_window = 0;     // points drawn that lie in the window
    std::vector<double> distances; // of those that no region covers, in order of drawing
};

/// One uniform point in each of about `count` equal squares over the window's bounding box
/// (stratified sampling); the same numbers for the same seed on any number of threads. No
/// distances when there are no regions.
GapSamples sample_gaps(const PlacedRegions& regions, const RegionDistance& distance,
                       std::size_t count, std::uint64_t seed = 0);

/// For each element the distance from its region to the nearest other one [m]; infinity for an
/// element that is alone.
std::vector<double> neighbour_distances(const PlacedRegions& regions,
                                        const RegionDistance& distance);

/// What a list of numbers looks like. Quantiles interpolate between order statistics (Hyndman &
/// Fan 1996, type 7). Numbers that are not finite are left out; all zero when none is left.
struct Summary {
    std::size_t count = 0;
    double mean = 0, median = 0, percentile_95 = 0, maximum = 0;
};
Summary summary(std::vector<double> values);

/// Probability density over equal bins from 0 to `limit`; the values beyond are left out, but
/// count in the normalisation, so the integral is the share of values below the limit.
struct Histogram {
    double bin_width = 0;
    std::vector<double> density; // [1/unit of the values]
};
Histogram histogram(std::span<const double> values, double limit, std::size_t bins);

} // namespace scree
