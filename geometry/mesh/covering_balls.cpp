// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/parallel.h"
#include "geometry/mesh/medial_balls.h"

#include <algorithm>
#include <numeric>
#include <queue>

namespace scree {

std::vector<Ball> covering_balls(std::span<const Ball> balls, std::span<const Vec3> points,
                                 double tolerance, std::size_t most, std::vector<bool>& reached) {
    // The points are sorted along the longest axis, so that each ball visits few of them.
    Box3 box;
    for (const Vec3& p : points)
        box.extendBy(p);
    const auto axis = static_cast<int>(box.majorAxis());
    std::vector<std::uint32_t> order(points.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(),
              [&](std::uint32_t a, std::uint32_t b) { return points[a][axis] < points[b][axis]; });
    std::vector<std::vector<std::uint32_t>> reach(balls.size());
    parallel_for(balls.size(), 16, [&](std::size_t b) {
        const float far = balls[b].radius + static_cast<float>(tolerance);
        const Vec3& centre = balls[b].centre;
        const auto first =
            std::lower_bound(order.begin(), order.end(), centre[axis] - far,
                             [&](std::uint32_t p, float least) { return points[p][axis] < least; });
        for (auto p = first; p != order.end() && points[*p][axis] <= centre[axis] + far; ++p)
            if ((points[*p] - centre).length2() <= far * far)
                reach[b].push_back(*p);
    });
    // The number of points that a ball adds only shrinks while others are taken, so that an old
    // number is an upper bound (lazy greedy, Minoux 1978). Of equal balls the first is taken.
    using Entry = std::pair<std::size_t, std::size_t>; // number of points added; index from the end
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
