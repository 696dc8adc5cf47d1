// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/placed_regions.h"

#include <span>

namespace scree {

/// The pair correlation function g(r) of points: the density of pairs at distance r relative to
/// that of a Poisson process, for which it is 1.
struct PairCorrelation {
    double bin_width = 0;      // [m]; bin k holds distances from k to k + 1 widths
    std::vector<double> value; // 0 in bins where no pairs are expected
};

/// Counts pairs up to `reach` [m] in `bins` bins. On a torus distances are periodic and need no
/// edge correction; `reach` must be below half a side. In other windows each bin's count is divided
/// by its expectation from the isotropised set covariance of the window: the rigid-motion
/// correction (Ohser & Stoyan 1981; Illian et al. 2008, section 4.2), which is unbiased for
/// homogeneous isotropic processes.
PairCorrelation pair_correlation(std::span<const Vec2> points, const Window& window, double reach,
                                 std::size_t bins);

/// Isotropised set covariance: the area of the intersection of the window with itself translated by
/// r, averaged over directions [m^2].
double set_covariance(const Window& window, double r);

} // namespace scree
