// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/pile/insertion.h"

#include "core/parallel.h"

#include <algorithm>

namespace scree {

namespace {

double highest(const PileKind& kind, const InsertionSettings& settings) {
    return std::min(kind.range(), settings.ceiling);
}

double limit_of(const PileKind& kind, double level, const InsertionSettings& settings) {
    return std::min(highest(kind, settings), level * kind.component.radius);
}

/// Candidates that are advanced at the same time against what is placed before them, and then in
/// their order against each other. As large as it may be with few conflicts within; not a function
/// of the number of threads, since the outcome depends on it in the last digits.
std::size_t batch_size(std::size_t count) { return std::clamp<std::size_t>(count / 64, 64, 4096); }

void move_on(const Pile& pile, InsertionCandidate& candidate, double level,
             const InsertionSettings& settings) {
    const double limit = limit_of(pile.kinds[candidate.site.kind], level, settings);
    const Advance moved = advance(pile, candidate.site, candidate.height, limit, settings.overlap);
    candidate.height = moved.height;
    candidate.placed = moved.free;
}

// Whether one of those from number `first` is in its way.
bool blocked_by_newer(const Pile& pile, const InsertionCandidate& candidate, std::size_t first,
                      double overlap) {
    const Placed placed = candidate.site.at(candidate.height);
    bool blocked = false;
    pile.hash.near(placed.pose.centre, pile.component(placed).reach, [&](std::uint32_t index) {
        blocked = blocked || (index >= first && !is_free(pile, placed, pile.all[index], overlap));
    });
    return blocked;
}

void insert_batch(double level, Pile& pile, std::span<InsertionCandidate> batch,
                  const InsertionSettings& settings) {
    const std::size_t first = pile.all.size();
    parallel_for(batch.size(), 1, [&](std::size_t i) {
        if (batch[i].height <= limit_of(pile.kinds[batch[i].site.kind], level, settings))
            move_on(pile, batch[i], level, settings);
    });
    for (InsertionCandidate& candidate : batch) {
        if (candidate.placed && blocked_by_newer(pile, candidate, first, settings.overlap))
            move_on(pile, candidate, level, settings);
        if (candidate.placed)
            pile.add(candidate.site.at(candidate.height));
    }
}

} // namespace

std::vector<InsertionCandidate> candidates_at(std::vector<PileSite> sites,
                                              std::span<const PileKind> kinds,
                                              const InsertionSettings& settings) {
    std::vector<InsertionCandidate> candidates;
    candidates.reserve(sites.size());
    for (PileSite& site : sites) {
        const double lowest = -settings.sink * kinds[site.kind].component.radius;
        candidates.push_back({std::move(site), lowest});
    }
    return candidates;
}

void insert_up_to(double level, Pile& pile, std::vector<InsertionCandidate>& candidates,
                  const InsertionSettings& settings, const Context& context) {
    const std::size_t size = batch_size(candidates.size());
    for (std::size_t first = 0; first < candidates.size(); first += size) {
        context.check_cancel();
        insert_batch(
            level, pile,
            std::span(candidates).subspan(first, std::min(size, candidates.size() - first)),
            settings);
    }
    std::erase_if(candidates, [&](const InsertionCandidate& candidate) {
        return candidate.placed ||
               candidate.height > highest(pile.kinds[candidate.site.kind], settings);
    });
}

} // namespace scree
