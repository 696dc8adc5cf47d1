// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/rocks/plan.h"

#include <algorithm>
#include <limits>

namespace scree::rocks {

Plan::Plan(const WideVec3& a, const WideVec3& b, const WideVec3& c)
    : corners{a, b, c}, low(std::min({a.y, b.y, c.y})), high(std::max({a.y, b.y, c.y})) {
    for (const WideVec3& p : corners)
        box.extendBy(Vec2f(Vec2(p.x, p.z)));
    const WideVec3 normal = (b - a).cross(c - a);
    if (normal.y != 0) {
        slope_x = -normal.x / normal.y;
        slope_z = -normal.z / normal.y;
    }
    if (normal.y > 0)
        std::swap(corners[1], corners[2]);
}

double least_between(const Plan& upper, const Plan& lower) {
    const double low_x = double(std::max(upper.box.min.x, lower.box.min.x));
    const double low_z = double(std::max(upper.box.min.y, lower.box.min.y));
    const double high_x = double(std::min(upper.box.max.x, lower.box.max.x));
    const double high_z = double(std::min(upper.box.max.y, lower.box.max.y));
    if (low_x > high_x || low_z > high_z)
        return std::numeric_limits<double>::infinity();
    // The difference of two planes over a rectangle is least in one of its corners.
    const double x = (low_x + high_x) / 2;
    const double z = (low_z + high_z) / 2;
    const double least = upper.height(x, z) - lower.height(x, z) -
                         std::abs(upper.slope_x - lower.slope_x) * (high_x - x) -
                         std::abs(upper.slope_z - lower.slope_z) * (high_z - z);
    return std::max(least, upper.low - lower.high);
}

CommonArea::CommonArea(const Plan& a, const Plan& b) {
    for (int i = 0; i < 3; ++i) {
        const WideVec3& p = a.corners[std::size_t(i)];
        corners[std::size_t(i)] = {{p.x, p.z}, i, (i + 2) % 3};
    }
    count = 3;
    for (int i = 0; i < 3 && count > 0; ++i) {
        const WideVec3& p = b.corners[std::size_t(i)];
        const WideVec3& q = b.corners[std::size_t((i + 1) % 3)];
        clip({p.x, p.z}, {q.x, q.z}, 3 + i);
    }
}

void CommonArea::clip(const Vec2& from, const Vec2& to, int line) {
    const Vec2 along = to - from;
    std::array<double, 9> side; // of the line on which each corner is
    double least = 0;
    for (std::size_t i = 0; i < count; ++i) {
        side[i] = cross(along, corners[i].place - from);
        least = std::min(least, side[i]);
    }
    if (least >= 0)
        return;
    const std::array<Corner, 9> before = corners;
    const std::size_t had = count;
    count = 0;
    for (std::size_t i = 0; i < had; ++i) {
        const std::size_t next = i + 1 < had ? i + 1 : 0;
        const Corner& p = before[i];
        const Corner& q = before[next];
        if (side[i] >= 0)
            corners[count++] = p;
        if ((side[i] > 0 && side[next] < 0) || (side[i] < 0 && side[next] > 0)) {
            const Vec2 place = p.place + (q.place - p.place) * (side[i] / (side[i] - side[next]));
            corners[count++] =
                side[i] > 0 ? Corner{place, line, p.side} : Corner{place, p.side, line};
        }
    }
}

} // namespace scree::rocks
