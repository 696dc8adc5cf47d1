// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/bodies/insertion.h"

#include "core/parallel.h"

#include <algorithm>
#include <numeric>

namespace scree {

namespace {

double highest(const PileKind& kind, const InsertionSettings& settings) {
    return std::min(kind.range(), settings.ceiling);
}

double limit_of(const PileKind& kind, double level, const InsertionSettings& settings) {
    return std::min(highest(kind, settings), level * kind.component.radius);
}

/// Candidates that are advanced at the same time against what is placed before them; those in the
/// way of one before them in their order are advanced again with the next round. As large as it may
/// be with few conflicts within; not a function of the number of threads, since the outcome depends
/// on it in the last digits.
std::size_t batch_size(std::size_t count) { return std::clamp<std::size_t>(count / 64, 64, 4096); }

void come_free(const Pile& pile, InsertionCandidate& candidate, double level,
               const InsertionSettings& settings) {
    candidate.placed = false;
    const double limit = limit_of(pile.kinds[candidate.site.kind], level, settings);
    if (candidate.height > limit)
        return;
    const Advance moved = advance(pile, candidate.site, candidate.height, limit, settings.overlap);
    candidate.height = moved.height;
    candidate.placed = moved.free;
    candidate.at = candidate.site.at(moved.height);
}

// Whether one of those from number `first` is in its way.
bool is_blocked(const Pile& pile, const Placed& placed, std::size_t first, double overlap) {
    bool blocked = false;
    pile.hash.near(placed.pose.centre, pile.component(placed).reach, [&](std::uint32_t index) {
        blocked = blocked || (index >= first && !is_free(pile, placed, pile.all[index], overlap));
    });
    return blocked;
}

void insert_batch(double level, Pile& pile, std::span<InsertionCandidate> batch,
                  const InsertionSettings& settings) {
    std::vector<std::size_t> open(batch.size());
    std::iota(open.begin(), open.end(), std::size_t{0});
    while (!open.empty()) {
        const std::size_t first = pile.all.size();
        parallel_for(open.size(), 1, [&](std::size_t k) {
            InsertionCandidate& candidate = batch[open[k]];
            come_free(pile, candidate, level, settings);
            if (candidate.placed && settings.settler != nullptr)
                candidate.at = settings.settler->settle(pile, candidate.at);
        });
        std::erase_if(open, [&](std::size_t i) {
            InsertionCandidate& candidate = batch[i];
            if (!candidate.placed)
                return true;
            candidate.placed = !is_blocked(pile, candidate.at, first, settings.overlap);
            if (candidate.placed)
                pile.add(candidate.at);
            return candidate.placed;
        });
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
