// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/pile/insertion.h"

#include "core/parallel.h"

#include <algorithm>

namespace scree {

namespace {

// Of a layer, in radii: what finds no room in one waits for the next, so that the pile grows
// evenly.
constexpr double layer_height = 1;

/// A site whose component is blocked below `height`.
struct Candidate {
    PileSite site;
    double height;
    double limit; // of the layer
    bool free = false;
};

/// Candidates that are advanced at the same time against what is placed before them, and then in
/// their order against each other. As large as it may be with few conflicts within; not a function
/// of the number of threads, since the outcome depends on it in the last digits.
std::size_t batch_size(std::size_t count) { return std::clamp<std::size_t>(count / 64, 64, 4096); }

void advance_candidate(const Pile& pile, Candidate& candidate, double overlap) {
    const Advance moved = advance(pile, candidate.site, candidate.height, candidate.limit, overlap);
    candidate.height = moved.height;
    candidate.free = moved.free;
}

bool near_newer(const Pile& pile, const Candidate& candidate, std::size_t first) {
    const Placed placed = candidate.site.at(candidate.height);
    bool any = false;
    pile.hash.near(placed.pose.centre, pile.component(placed).reach,
                   [&](std::uint32_t index) { any = any || index >= first; });
    return any;
}

void insert_batch(Pile& pile, std::vector<Candidate>& candidates,
                  std::span<const std::uint32_t> batch, double overlap) {
    const std::size_t first = pile.all.size();
    parallel_for(batch.size(), 1,
                 [&](std::size_t i) { advance_candidate(pile, candidates[batch[i]], overlap); });
    for (const std::uint32_t i : batch) {
        Candidate& candidate = candidates[i];
        if (candidate.free && near_newer(pile, candidate, first))
            advance_candidate(pile, candidate, overlap);
        if (candidate.free)
            pile.add(candidate.site.at(candidate.height));
    }
}

} // namespace

void insert_components(Pile& pile, std::span<const PileSite> sites,
                       const InsertionSettings& settings, const Context& context) {
    std::vector<Candidate> candidates;
    candidates.reserve(sites.size());
    double layers = 1;
    for (const PileSite& site : sites) {
        const PileKind& kind = pile.kinds[site.kind];
        const double sink = settings.sink * kind.component.radius;
        candidates.push_back({site, -sink, 0});
        layers = std::max(
            layers, std::ceil((sink + kind.range()) / (layer_height * kind.component.radius)));
    }
    const std::size_t size = batch_size(candidates.size());
    for (int layer = 1; layer <= static_cast<int>(layers); ++layer) {
        std::vector<std::uint32_t> open;
        for (std::uint32_t i = 0; i < candidates.size(); ++i) {
            Candidate& candidate = candidates[i];
            const PileKind& kind = pile.kinds[candidate.site.kind];
            candidate.limit = std::min(kind.range(), (layer * layer_height - settings.sink) *
                                                         kind.component.radius);
            if (!candidate.free && candidate.height <= candidate.limit)
                open.push_back(i);
        }
        for (std::size_t first = 0; first < open.size(); first += size) {
            context.check_cancel();
            context.report("pile", (layer - 1 + double(first) / double(open.size())) / layers);
            insert_batch(pile, candidates,
                         std::span(open).subspan(first, std::min(size, open.size() - first)),
                         settings.overlap);
        }
    }
}

} // namespace scree
