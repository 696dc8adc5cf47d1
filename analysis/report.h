// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/gaps.h"
#include "analysis/largest_empty_circle.h"
#include "analysis/pair_correlation.h"
#include "analysis/power_spectrum.h"

#include <optional>

namespace scree {

/// Number of sample points for gaps that `analyse` uses per layout.
inline constexpr std::size_t gap_sample_count = std::size_t{1} << 17;

/// Measurements of a single layout.
struct LayoutFigures {
    std::uint64_t seed = 0;
    std::size_t count = 0;
    std::vector<std::size_t> count_by_kind;
    std::optional<double> fill;                 // share of the window covered by regions
    std::optional<Circle> largest_empty_circle; // both only if regions are known
};

/// The measurements of one layout, or of several layouts of one scene with different seeds: their
/// gaps are pooled, their pair correlations and spectra averaged.
struct AnalysisReport {
    double window_area = 0; // [m^2]
    bool torus = false;
    double spacing = 0; // mean spacing [m]: sqrt(window area / elements) of the first layout
    std::vector<std::string> kind_names;
    std::vector<LayoutFigures> layouts;

    bool has_regions = false; // whether the next four are set
    Summary gap;              // distance from the free space to the nearest region [m]
    Histogram gap_histogram;
    Summary neighbour; // distance from a region to the nearest other region [m]
    Histogram neighbour_histogram;

    PairCorrelation pair_correlation;
    std::vector<PairCorrelation> pair_correlation_by_kind; // of pairs of equal kind
    PowerSpectrum spectrum;
    RadialSpectrum radial;
    std::vector<RadialSpectrum> radial_by_kind; // of the points of each kind, in the same annuli
};

/// Measures layouts, at least one, in the same window; `seeds` are their seeds.
AnalysisReport analyse(std::span<const PlacedRegions> layouts,
                       std::span<const std::uint64_t> seeds);

} // namespace scree
