// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/placed_regions.h"

#include <span>

namespace scree {

/// g(r) of points: how many pairs lie at distance r, relative to points placed at random without
/// regard to each other, for which it is 1.
struct PairCorrelation {
    double bin_width = 0;      // [m]; bin k holds distances from k to k + 1 widths
    std::vector<double> value; // 0 where there is nothing to compare with
};

/// Counts pairs up to `reach` [m] in `bins` bins. Edges: on a torus distances wrap and none is
/// corrected, for which `reach` must be below half a side; elsewhere each bin's count is divided by
/// its expectation from the window's isotropised set covariance, the rigid-motion correction
/// (Ohser & Stoyan 1981; Illian et al. 2008, section 4.2), which is unbiased for points that are
/// homogeneous and isotropic.
PairCorrelation pair_correlation(std::span<const Vec2> points, const Window& window, double reach,
                                 std::size_t bins);

/// Area of the window's intersection with itself moved by r, averaged over directions [m^2].
double set_covariance(const Window& window, double r);

} // namespace scree
