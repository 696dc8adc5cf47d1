// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/bodies/insertion.h"

#include "core/parallel.h"

#include <algorithm>
#include <numeric>

namespace scree {

namespace {

/// How many candidates are advanced at the same time, each against the bodies placed before the
/// batch; those that turn out to be in the way of an earlier one of the batch are advanced again in
/// its next round. The larger the better for the threads, as long as such conflicts are few. It
/// must not depend on the number of threads, since it changes the last digits of the outcome.
std::size_t batch_size(std::size_t count) { return std::clamp<std::size_t>(count / 64, 64, 4096); }

void come_free(const PlacedBodies& bodies, InsertionCandidate& candidate, double level,
               const InsertionSettings& settings) {
    candidate.placed = false;
    const double limit =
        std::min(candidate.highest, level * bodies.shapes[candidate.site.body]->radius);
    if (candidate.height > limit)
        return;
    const Advance moved =
        advance(bodies, candidate.site, candidate.height, limit, settings.overlap);
    candidate.height = moved.height;
    candidate.placed = moved.free;
    candidate.at = candidate.site.at(moved.height);
}

// By one of those placed with a number of `first` or more.
bool is_blocked(const PlacedBodies& bodies, const PlacedBody& placed, std::size_t first,
                double overlap) {
    bool blocked = false;
    bodies.hash.near(placed.pose.centre, bodies.body(placed).reach, [&](std::uint32_t index) {
        blocked =
            blocked || (index >= first && !is_free(bodies, placed, bodies.all[index], overlap));
    });
    return blocked;
}

void insert_batch(double level, PlacedBodies& bodies, std::span<InsertionCandidate> batch,
                  const InsertionSettings& settings) {
    std::vector<std::size_t> open(batch.size());
    std::iota(open.begin(), open.end(), std::size_t{0});
    while (!open.empty()) {
        const std::size_t first = bodies.all.size();
        parallel_for(open.size(), 1, [&](std::size_t k) {
            InsertionCandidate& candidate = batch[open[k]];
            come_free(bodies, candidate, level, settings);
            if (candidate.placed && settings.settler != nullptr)
                candidate.at = settings.settler->settle(bodies, candidate.at);
        });
        std::erase_if(open, [&](std::size_t i) {
            InsertionCandidate& candidate = batch[i];
            if (!candidate.placed)
                return true;
            candidate.placed = !is_blocked(bodies, candidate.at, first, settings.overlap);
            if (candidate.placed)
                bodies.add(candidate.at);
            return candidate.placed;
        });
    }
}

} // namespace

std::vector<InsertionCandidate> candidates_at(std::vector<BodySite> sites, const Bodies& bodies,
                                              std::span<const double> ranges,
                                              const InsertionSettings& settings) {
    std::vector<InsertionCandidate> candidates;
    candidates.reserve(sites.size());
    for (BodySite& site : sites) {
        const double lowest = -settings.sink * bodies[site.body]->radius;
        const double highest = std::min(ranges[site.body], settings.ceiling);
        candidates.push_back({std::move(site), lowest, highest});
    }
    return candidates;
}

void insert_up_to(double level, PlacedBodies& bodies, std::vector<InsertionCandidate>& candidates,
                  const InsertionSettings& settings, const Context& context) {
    const std::size_t size = batch_size(candidates.size());
    for (std::size_t first = 0; first < candidates.size(); first += size) {
        context.check_cancel();
        insert_batch(
            level, bodies,
            std::span(candidates).subspan(first, std::min(size, candidates.size() - first)),
            settings);
    }
    std::erase_if(candidates, [](const InsertionCandidate& candidate) {
        return candidate.placed || candidate.height > candidate.highest;
    });
}

} // namespace scree
