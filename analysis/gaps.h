// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/region_distance.h"

namespace scree {

/// Distances to the nearest region [m] from sample points in the free space, the part of the window
/// that no region covers.
struct GapSamples {
    std::size_t in_window = 0;     // number of samples in the window
    std::vector<double> distances; // of the samples in the free space, in sampling order
};

/// Stratified sampling: one uniform point in each of about `count` equal squares over the window's
/// bounding box. The result does not depend on the number of threads. There are no distances when
/// there are no regions.
GapSamples sample_gaps(const PlacedRegions& regions, const RegionDistance& distance,
                       std::size_t count, std::uint64_t seed = 0);

/// For each element the distance from its region to the nearest other region [m]; infinity when
/// there is none.
std::vector<double> neighbour_distances(const PlacedRegions& regions,
                                        const RegionDistance& distance);

/// Summary statistics of a list of numbers. Quantiles interpolate between order statistics (Hyndman
/// & Fan 1996, type 7). Non-finite numbers are ignored; all are 0 when no number is left.
struct Summary {
    std::size_t count = 0;
    double mean = 0, median = 0, percentile_95 = 0, maximum = 0;
};
Summary summary(std::vector<double> values);

/// Probability density over equal bins from 0 to `limit`. Larger values are not shown but count in
/// the normalisation, so that the integral is the share of values below the limit.
struct Histogram {
    double bin_width = 0;
    std::vector<double> density; // [1/unit of the values]
};
Histogram histogram(std::span<const double> values, double limit, std::size_t bins);

} // namespace scree
