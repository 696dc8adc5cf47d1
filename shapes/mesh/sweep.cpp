// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes/mesh/sweep.h"

#include <algorithm>

namespace scree {

BentAxis::BentAxis(double length, const std::vector<double>& curvature)
    : length_(length), points_{{0, 0}}, heading_{0} {
    const double step = length / double(curvature.size());
    for (const double k : curvature) {
        const double middle = heading_.back() + k * step / 2;
        points_.push_back(points_.back() + Vec2(std::cos(middle), std::sin(middle)) * step);
        heading_.push_back(heading_.back() + k * step);
    }
}

SpaceRing BentAxis::place(const Ring& section, double t) const {
    const double at = std::clamp(t, 0.0, 1.0) * double(points_.size() - 1);
    const std::size_t i = std::min(std::size_t(at), points_.size() - 2);
    const double share = at - double(i);
    // Beyond its ends the axis is straight.
    const double beyond = (t - std::clamp(t, 0.0, 1.0)) * length_;
    const double heading = heading_[i] * (1 - share) + heading_[i + 1] * share;
    const Vec2 along(std::cos(heading), std::sin(heading));
    const Vec2 center = points_[i] * (1 - share) + points_[i + 1] * share + along * beyond;
    const Vec2 side(along.y, -along.x); // up x along, in (x, z)
    SpaceRing ring;
    for (const Vec2& p : section) {
        const Vec2 foot = center + side * p.x;
        ring.emplace_back(static_cast<float>(foot.x), static_cast<float>(p.y),
                          static_cast<float>(foot.y));
    }
    return ring;
}

double interpolate(const std::vector<Vec2>& knots, double x) {
    const auto last = knots.size() - 1;
    x = std::clamp(x, knots.front().x, knots.back().x);
    std::size_t i = 0;
    while (i + 1 < last && x > knots[i + 1].x)
        ++i;
    const auto secant = [&](std::size_t k) {
        return (knots[k + 1].y - knots[k].y) / (knots[k + 1].x - knots[k].x);
    };
    const auto slope = [&](std::size_t k) {
        if (k == 0 || k == last)
            return secant(k == 0 ? 0 : last - 1);
        const double a = secant(k - 1);
        const double b = secant(k);
        return a * b <= 0 ? 0 : 2 * a * b / (a + b); // harmonic mean
    };
    const double width = knots[i + 1].x - knots[i].x;
    const double t = (x - knots[i].x) / width;
    const double u = 1 - t;
    return knots[i].y * u * u * (1 + 2 * t) + knots[i + 1].y * t * t * (1 + 2 * u) +
           width * t * u * (slope(i) * u - slope(i + 1) * t);
}

} // namespace scree
