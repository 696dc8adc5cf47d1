// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/parallel.h"
#include "generators/pile/medial_balls.h"

#include <queue>

namespace scree {

std::vector<Ball> covering_balls(std::span<const Ball> balls, std::span<const Vec3> points,
                                 double tolerance, std::size_t most, std::vector<bool>& reached) {
    std::vector<std::vector<std::uint32_t>> reach(balls.size());
    parallel_for(balls.size(), 16, [&](std::size_t b) {
        const float far = balls[b].radius + static_cast<float>(tolerance);
        for (std::uint32_t p = 0; p < points.size(); ++p)
            if ((points[p] - balls[b].centre).length2() <= far * far)
                reach[b].push_back(p);
    });
    // What a ball adds only shrinks while others are taken, so that an old count is a bound (lazy
    // greedy, Minoux 1978). Of equal ones the first comes first.
    using Entry = std::pair<std::size_t, std::size_t>; // what it adds; index from the end
    std::priority_queue<Entry> queue;
    for (std::size_t b = 0; b < balls.size(); ++b)
        queue.emplace(reach[b].size(), balls.size() - b);
    reached.assign(points.size(), false);
    std::vector<Ball> chosen;
    while (!queue.empty() && chosen.size() < most) {
        const auto [bound, from_end] = queue.top();
        queue.pop();
        const std::size_t b = balls.size() - from_end;
        std::erase_if(reach[b], [&](std::uint32_t p) { return reached[p]; });
        if (reach[b].empty())
            continue;
        if (reach[b].size() < bound && !queue.empty() &&
            Entry(reach[b].size(), from_end) < queue.top()) {
            queue.emplace(reach[b].size(), from_end);
            continue;
        }
        for (const std::uint32_t p : reach[b])
            reached[p] = true;
        chosen.push_back(balls[b]);
    }
    return chosen;
}

} // namespace scree
