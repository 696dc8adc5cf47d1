// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/placed_regions.h"

#include <span>

namespace scree {

/// The power spectrum of points, P(f) = |sum over points p of exp(-2 pi i f.p)|^2 / n, at integer
/// multiples of `step`, the inverse sides of the window's bounding box. Its mean is 1 for a Poisson
/// process. Stored for f.y >= 0; the other half-plane is its mirror image.
struct PowerSpectrum {
    Vec2 step; // [1/m]
    int reach_x = 0;
    int reach_y = 0;
    std::vector<double> power; // row y, column reach_x + x; 0 at frequency 0

    std::size_t width() const { return 2 * std::size_t(reach_x) + 1; }
    double at(int x, int y) const {
        return y < 0 ? at(-x, -y) : power[std::size_t(y) * width() + std::size_t(reach_x + x)];
    }
};

/// The periodogram up to the frequency `highest` [1/m], but at most 1023 steps along an axis. On a
/// torus it is that of the periodic tiling. In other windows the transform of the window times the
/// density is subtracted from the sum first (the directly debiased estimator of Hawat et al. 2023),
/// since it would dominate at low frequencies. All zero without points.
PowerSpectrum periodogram(std::span<const Vec2> points, const Window& window, double highest);

/// The mean of periodograms of the same frequencies (Bartlett 1948).
PowerSpectrum mean_spectrum(std::span<const PowerSpectrum> spectra);

/// Radial statistics of the spectrum (Ulichney 1987, section 3.3; Lagae & Dutre 2008): the mean of
/// the power over each annulus, and its anisotropy, the sample variance divided by the squared
/// mean, in dB. For isotropic points the anisotropy of the mean of K periodograms is -10 log10 K.
struct RadialSpectrum {
    double bin_width = 0;              // [1/m]; annulus k holds frequencies from k to k + 1 widths
    std::vector<double> power;         // 0 where an annulus is empty
    std::vector<double> anisotropy_db; // NaN where an annulus has fewer than two frequencies
    std::vector<std::size_t> count;    // frequencies in the annulus, half the plane
};

/// The annuli are as wide as the larger step, or wider so that there are at most `max_bins`.
RadialSpectrum radial_spectrum(const PowerSpectrum& spectrum, std::size_t max_bins = 150);

} // namespace scree
