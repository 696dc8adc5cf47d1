// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "analysis/gaps.h"
#include "analysis/largest_empty_circle.h"
#include "analysis/pair_correlation.h"
#include "analysis/power_spectrum.h"

#include <optional>

namespace scree {

/// Points of the free space that `analyse` draws per layout.
inline constexpr std::size_t gap_sample_count = std::size_t{1} << 17;

/// What is measured of one layout by itself.
struct LayoutFigures {
    std::uint64_t seed = 0;
    std::size_t count = 0;
    std::vector<std::size_t> count_by_kind;
    std::optional<double> fill;                 // share of the window that regions cover
    std::optional<Circle> largest_empty_circle; // both only where regions are known
};

/// The figures of a layout, or of several from one scene with different seeds: gaps of all pooled,
/// pair correlation and spectrum averaged.
struct AnalysisReport {
    double window_area = 0; // [m^2]
    bool torus = false;
    double spacing = 0; // mean spacing [m]: sqrt(window area / elements) of the first layout
    std::vector<std::string> kind_names;
    std::vector<LayoutFigures> layouts;

    bool has_regions = false; // the next four
    Summary gap;              // distance from the free space to the nearest region [m]
    Histogram gap_histogram;
    Summary neighbour; // distance from a region to the nearest other one [m]
    Histogram neighbour_histogram;

    PairCorrelation pair_correlation;
    std::vector<PairCorrelation> pair_correlation_by_kind; // pairs of one kind
    PowerSpectrum spectrum;
    RadialSpectrum radial;
    std::vector<RadialSpectrum> radial_by_kind; // points of one kind, in the same annuli
};

/// Measures layouts of one window; there must be at least one. `seeds` name them.
AnalysisReport analyse(std::span<const PlacedRegions> layouts,
                       std::span<const std::uint64_t> seeds);

} // namespace scree
