// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/figures/inscribed_disks.h"

#include <algorithm>

namespace scree {

namespace {

/// How good p is as the next centre: its distance to the edges, and to the disks before.
double merit(const std::vector<Disk>& disks, const Vec2& p, double edge_distance) {
    double result = edge_distance;
    for (const Disk& disk : disks)
        result = std::min(result, (p - disk.centre).length() - disk.radius);
    return result;
}

} // namespace

std::vector<Disk> inscribed_disks(const Region& region, std::size_t count) {
    constexpr int cells = 48; // per side of the first search
    const Box2 box = bounds(region);
    const Vec2 cell = box.size() / double(cells);
    struct Sample {
        Vec2 point;
        double distance;
    };
    std::vector<Sample> samples;
    for (int y = 0; y < cells; ++y) {
        for (int x = 0; x < cells; ++x) {
            const Vec2 p = box.min + cell * Vec2(x + 0.5, y + 0.5);
            const double distance = -signed_distance(region, p);
            if (distance > 0)
                samples.push_back({p, distance});
        }
    }
    std::vector<Disk> disks;
    while (disks.size() < count && !samples.empty()) {
        Vec2 best;
        double best_merit = 0;
        for (const Sample& sample : samples) {
            const double value = merit(disks, sample.point, sample.distance);
            if (value > best_merit) {
                best = sample.point;
                best_merit = value;
            }
        }
        if (best_merit <= 0)
            break;
        for (double step = std::max(cell.x, cell.y); step > 1e-4 * best_merit;) {
            const Vec2 from = best;
            for (const Vec2& move :
                 {Vec2(step, 0), Vec2(-step, 0), Vec2(0, step), Vec2(0, -step)}) {
                const Vec2 p = from + move;
                const double value = merit(disks, p, -signed_distance(region, p));
                if (value > best_merit) {
                    best = p;
                    best_merit = value;
                }
            }
            if (best == from)
                step /= 2;
        }
        disks.push_back({best, -signed_distance(region, best)});
        // A disk of a fifth of the largest one's radius has 4% of its area: it hits too rarely.
        if (disks.back().radius < disks.front().radius / 5) {
            disks.pop_back();
            break;
        }
    }
    return disks;
}

} // namespace scree
