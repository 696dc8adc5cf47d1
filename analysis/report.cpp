// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/report.h"

#include "analysis/covered_area.h"

#include <algorithm>
#include <cassert>

namespace scree {

namespace {

// In units of the mean spacing: g(r) is flat beyond 6 unless the layout is a lattice, and the
// spectrum is flat beyond a frequency of 3.
constexpr double pair_reach = 6;
constexpr std::size_t pair_bins = 90;
constexpr double highest_frequency = 3;
constexpr std::size_t gap_bins = 60;
constexpr std::size_t neighbour_bins = 30; // one distance per element: fewer, wider bins

LayoutFigures figures_of(const PlacedRegions& layout, std::uint64_t seed) {
    LayoutFigures figures{seed, layout.positions.size(), {}, {}, {}};
    figures.count_by_kind.resize(layout.kind_names.size());
    for (const std::uint32_t kind : layout.kinds)
        ++figures.count_by_kind[kind];
    return figures;
}

std::vector<Vec2> points_of_kind(const PlacedPoints& points, std::uint32_t kind) {
    std::vector<Vec2> out;
    for (std::size_t i = 0; i < points.positions.size(); ++i)
        if (points.kinds[i] == kind)
            out.push_back(points.positions[i]);
    return out;
}

void measure_regions(std::span<const PlacedRegions> layouts, AnalysisReport& report) {
    std::vector<double> gaps;
    std::vector<double> neighbours;
    for (std::size_t i = 0; i < layouts.size(); ++i) {
        const PlacedRegions& layout = layouts[i];
        const RegionDistance distance(layout);
        report.layouts[i].fill = covered_area(layout) / report.window_area;
        report.layouts[i].largest_empty_circle = largest_empty_circle(layout, distance);
        const GapSamples samples =
            sample_gaps(layout, distance, gap_sample_count, report.layouts[i].seed);
        gaps.insert(gaps.end(), samples.distances.begin(), samples.distances.end());
        const std::vector<double> nearest = neighbour_distances(layout, distance);
        neighbours.insert(neighbours.end(), nearest.begin(), nearest.end());
    }
    report.gap = summary(gaps);
    report.gap_histogram = histogram(gaps, report.gap.maximum, gap_bins);
    report.neighbour = summary(neighbours);
    // Limited to the scale of the gaps, since isolated elements would stretch the axis.
    const double limit = std::min(report.neighbour.maximum, 2 * report.gap.maximum);
    report.neighbour_histogram = histogram(neighbours, limit, neighbour_bins);
}

void add(PairCorrelation& sum, const PairCorrelation& part, double weight) {
    sum.bin_width = part.bin_width;
    sum.value.resize(part.value.size());
    for (std::size_t k = 0; k < part.value.size(); ++k)
        sum.value[k] += weight * part.value[k];
}

void measure_pairs(std::span<const PlacedRegions> layouts, AnalysisReport& report) {
    const Vec2 size = bounds(*layouts[0].window.domain).size();
    // Just below half a side: a torus repeats beyond, and other windows have few pairs.
    const double reach = std::min(pair_reach * report.spacing, 0.499 * std::min(size.x, size.y));
    const double share = 1 / double(layouts.size());
    report.pair_correlation_by_kind.resize(report.kind_names.size());
    for (const PlacedRegions& layout : layouts) {
        add(report.pair_correlation,
            pair_correlation(layout.positions, layout.window, reach, pair_bins), share);
        for (std::uint32_t kind = 0; kind < report.kind_names.size(); ++kind)
            add(report.pair_correlation_by_kind[kind],
                pair_correlation(points_of_kind(layout, kind), layout.window, reach, pair_bins),
                share);
    }
}

void measure_spectra(std::span<const PlacedRegions> layouts, AnalysisReport& report) {
    const auto mean_of = [&](const auto& points_of) {
        std::vector<PowerSpectrum> spectra;
        for (const PlacedRegions& layout : layouts)
            spectra.push_back(
                periodogram(points_of(layout), layout.window, highest_frequency / report.spacing));
        return mean_spectrum(spectra);
    };
    report.spectrum = mean_of([](const PlacedRegions& layout) { return layout.positions; });
    report.radial = radial_spectrum(report.spectrum);
    for (std::uint32_t kind = 0; kind < report.kind_names.size(); ++kind)
        report.radial_by_kind.push_back(radial_spectrum(
            mean_of([&](const PlacedRegions& layout) { return points_of_kind(layout, kind); })));
}

} // namespace

AnalysisReport analyse(std::span<const PlacedRegions> layouts,
                       std::span<const std::uint64_t> seeds) {
    assert(!layouts.empty() && seeds.size() == layouts.size());
    const PlacedRegions& first = layouts[0];
    AnalysisReport report;
    report.window_area = area(*first.window.domain);
    report.torus = first.window.torus;
    report.spacing =
        std::sqrt(report.window_area / double(std::max<std::size_t>(1, first.positions.size())));
    report.kind_names = first.kind_names;
    for (std::size_t i = 0; i < layouts.size(); ++i)
        report.layouts.push_back(figures_of(layouts[i], seeds[i]));
    report.has_regions =
        std::all_of(layouts.begin(), layouts.end(), [](const PlacedRegions& layout) {
            return layout.outlines.size() == layout.positions.size();
        });
    if (report.has_regions)
        measure_regions(layouts, report);
    measure_pairs(layouts, report);
    measure_spectra(layouts, report);
    return report;
}

} // namespace scree
