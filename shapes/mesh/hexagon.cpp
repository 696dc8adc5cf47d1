// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes/mesh/hexagon.h"

#include "shapes/mesh/outline.h"

#include <algorithm>

namespace scree {

Hexagon::Hexagon(double across_flats) {
    const double corner = across_flats / std::sqrt(3.0);
    constexpr int cells = 7; // along a flat
    std::vector<Corner> outline;
    for (int k = 0; k < 6; ++k) {
        const Vec2 from = rotate({corner, 0.0}, pi / 6 + pi / 3 * k);
        const Vec2 to = rotate({corner, 0.0}, pi / 6 + pi / 3 * (k + 1));
        outline.push_back({from.x, from.y, 0.05 * across_flats});
        for (int i = 1; i < cells; ++i) {
            const Vec2 p = from + (to - from) * (double(i) / cells);
            outline.push_back({p.x, p.y, 0});
        }
    }
    std::vector<Vec2> polar; // (angle, radius)
    for (const Vec2& p : round_corners(outline, 5)) {
        const double angle = std::atan2(p.y, p.x);
        polar.emplace_back(angle < 0 ? angle + 2 * pi : angle, p.length());
    }
    std::sort(polar.begin(), polar.end(), [](const Vec2& a, const Vec2& b) { return a.x < b.x; });
    for (const Vec2& p : polar) {
        angles.push_back(p.x);
        radii.push_back(p.y);
    }
}

SpaceRing Hexagon::chamfered(double y, double circle, double slope) const {
    SpaceRing ring;
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const double fall = std::max(radii[i] - circle, 0.0) * slope;
        const double angle = angles[i];
        ring.push_back(level_ring(std::span(&angle, 1), radii[i], y - fall).front());
    }
    return ring;
}

} // namespace scree
