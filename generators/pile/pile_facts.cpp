// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/pile/pile_facts.h"

#include "geometry/bodies/overlap_measure.h"

#include <fmt/format.h>

namespace scree {

void add_counts(const PlacedBodies& pile, std::span<const PileKind> kinds, Facts& facts) {
    std::vector<std::size_t> component_of; // by kind
    std::size_t components = 0;
    for (const PileKind& kind : kinds) {
        components += kind.shapes > 0;
        component_of.push_back(components - 1);
    }
    std::vector<double> counts(components, 0);
    for (const PlacedBody& placed : pile.all)
        ++counts[component_of[placed.body]];
    for (std::size_t k = 0; counts.size() > 1 && k < counts.size(); ++k)
        facts.emplace_back(fmt::format("count_{}", k + 1), counts[k]);
}

PlacedBodies at_their_sites(const PlacedBodies& pile) {
    PlacedBodies start(pile.shapes);
    for (PlacedBody placed : pile.all) {
        placed.pose.centre -= Imath::V3d(placed.normal) * placed.height;
        placed.height = 0;
        start.add(placed);
    }
    return start;
}

void add_overlap(const PlacedBodies& pile, const PlacedBodies& start, std::size_t most,
                 Facts& facts) {
    constexpr std::size_t volume_samples = 400;
    const OverlapMeasure before = measure_overlap(start, most, 0);
    const OverlapMeasure after = measure_overlap(pile, most, volume_samples);
    facts.insert(facts.end(), {{"measured", double(after.measured)},
                               {"start_depth_mean", before.mean_depth},
                               {"start_depth_99", before.percentile_99},
                               {"start_depth_max", before.largest_depth},
                               {"depth_mean", after.mean_depth},
                               {"depth_99", after.percentile_99},
                               {"depth_max", after.largest_depth},
                               {"volume_overlap", after.volume_share}});
}

} // namespace scree
