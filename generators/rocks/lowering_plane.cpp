// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/rocks/lowering_plane.h"

#include <algorithm>

namespace scree::rocks {

namespace {

constexpr int most_pivots = 100;
constexpr double tolerance = 1e-9; // of the reach

double cross(const Gap& a, const Gap& b) { return a.x * b.z - a.z * b.x; }

double turn(const Gap& a, const Gap& b, const Gap& c) {
    return (b.x - a.x) * (c.z - a.z) - (b.z - a.z) * (c.x - a.x);
}

LoweringPlane plane_through(const std::array<Gap, 3>& legs) {
    const double area = turn(legs[0], legs[1], legs[2]);
    LoweringPlane plane;
    const double h1 = legs[1].height - legs[0].height;
    const double h2 = legs[2].height - legs[0].height;
    const double x1 = legs[1].x - legs[0].x;
    const double z1 = legs[1].z - legs[0].z;
    const double x2 = legs[2].x - legs[0].x;
    const double z2 = legs[2].z - legs[0].z;
    plane.slope_x = (h1 * z2 - h2 * z1) / area;
    plane.slope_z = (x1 * h2 - x2 * h1) / area;
    plane.height = legs[0].height - plane.slope_x * legs[0].x - plane.slope_z * legs[0].z;
    return plane;
}

/// Which leg to replace so that the triangle still encloses the centre: 0, 1 or 2; -1 if none.
int leg_to_replace(const std::array<Gap, 3>& legs, const Gap& gap) {
    int best = -1;
    double most = 0;
    for (int i = 0; i < 3; ++i) {
        std::array<Gap, 3> next = legs;
        next[std::size_t(i)] = gap;
        const double area = turn(next[0], next[1], next[2]);
        if (!(area > 0))
            continue;
        const double inside =
            std::min({cross(next[0], next[1]), cross(next[1], next[2]), cross(next[2], next[0])});
        if (inside >= -1e-12 * area && (best < 0 || area > most)) {
            best = i;
            most = area;
        }
    }
    return best;
}

} // namespace

LoweringPlane lowering_plane(std::span<const Gap> gaps, double reach, double most_slope) {
    std::array<Gap, 3> legs;
    std::array<bool, 3> is_gap{};
    // Their triangle's inscribed circle has the radius `reach`.
    for (int i = 0; i < 3; ++i) {
        const double angle = 2 * pi * i / 3 + 0.3;
        legs[std::size_t(i)] = {2 * reach * std::cos(angle), 2 * reach * std::sin(angle),
                                reach * most_slope};
    }
    LoweringPlane plane = plane_through(legs);
    for (int pivot = 0; pivot < most_pivots; ++pivot) {
        const Gap* lowest = nullptr;
        double below = -tolerance * reach;
        for (const Gap& gap : gaps) {
            const double above =
                gap.height - plane.height - plane.slope_x * gap.x - plane.slope_z * gap.z;
            if (above < below) {
                below = above;
                lowest = &gap;
            }
        }
        if (lowest == nullptr)
            break;
        const int replaced = leg_to_replace(legs, *lowest);
        if (replaced < 0)
            break;
        legs[std::size_t(replaced)] = *lowest;
        is_gap[std::size_t(replaced)] = true;
        plane = plane_through(legs);
    }
    plane.held = is_gap[0] && is_gap[1] && is_gap[2];
    return plane;
}

} // namespace scree::rocks
