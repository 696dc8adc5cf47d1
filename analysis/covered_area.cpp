// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/covered_area.h"

#include "core/parallel.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace scree {

namespace {

// The integral over t in [0, 1] of max(0, min(e, f)), where e and f are linear from e0 to e1 and
// from f0 to f1.
double integral_of_lower(double e0, double e1, double f0, double f1) {
    std::array<double, 5> breaks{0, 1, 1, 1, 1};
    const auto add_zero = [&](std::size_t i, double at0, double at1) {
        if ((at0 < 0) != (at1 < 0))
            breaks[i] = at0 / (at0 - at1);
    };
    add_zero(1, e0 - f0, e1 - f1);
    add_zero(2, f0, f1);
    add_zero(3, e0, e1);
    std::sort(breaks.begin(), breaks.end());
    const auto value = [&](double t) {
        return std::max(0.0, std::min(e0 + t * (e1 - e0), f0 + t * (f1 - f0)));
    };
    double sum = 0;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
        sum += (breaks[i + 1] - breaks[i]) * (value(breaks[i]) + value(breaks[i + 1])) / 2;
    return sum;
}

// Whether the bounding box of an edge of the domain meets the box. If none does, the box lies
// entirely inside or outside.
bool meets_edges(const Region& domain, const Box2& box) {
    for (const Ring& ring : domain.rings)
        for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
            Box2 edge;
            edge.extendBy(ring[j]);
            edge.extendBy(ring[i]);
            if (edge.intersects(box))
                return true;
        }
    return false;
}

} // namespace

// The indicator function of a polygon is the sum over its edges of the signed indicators of the
// areas below them. So the area of an intersection is the sum over pairs of edges of the signed
// areas below both.
double intersection_area(const Region& a, const Region& b) {
    const double base = bounds(a).min.y;
    double area = 0;
    for (const Ring& ring_a : a.rings)
        for (std::size_t i = 0, j = ring_a.size() - 1; i < ring_a.size(); j = i++) {
            const Vec2& a0 = ring_a[j];
            const Vec2& a1 = ring_a[i];
            if (a0.x == a1.x)
                continue;
            for (const Ring& ring_b : b.rings)
                for (std::size_t k = 0, l = ring_b.size() - 1; k < ring_b.size(); l = k++) {
                    const Vec2& b0 = ring_b[l];
                    const Vec2& b1 = ring_b[k];
                    const double left = std::max(std::min(a0.x, a1.x), std::min(b0.x, b1.x));
                    const double right = std::min(std::max(a0.x, a1.x), std::max(b0.x, b1.x));
                    if (!(left < right))
                        continue;
                    const auto height = [&](const Vec2& p, const Vec2& q, double x) {
                        return p.y + (x - p.x) / (q.x - p.x) * (q.y - p.y) - base;
                    };
                    const double sign = (a1.x > a0.x) == (b1.x > b0.x) ? 1 : -1;
                    area += sign * (right - left) *
                            integral_of_lower(height(a0, a1, left), height(a0, a1, right),
                                              height(b0, b1, left), height(b0, b1, right));
                }
        }
    return area;
}

double covered_area(const PlacedRegions& regions) {
    const Region& domain = *regions.window.domain;
    std::vector<double> areas(regions.outlines.size());
    parallel_for(areas.size(), 64, [&](std::size_t i) {
        const Region& outline = regions.outlines[i];
        const Box2 box = bounds(outline);
        if (regions.window.torus || !meets_edges(domain, box))
            areas[i] = regions.window.torus || contains(domain, box.center()) ? area(outline) : 0;
        else
            areas[i] = intersection_area(outline, domain);
    });
    return std::accumulate(areas.begin(), areas.end(), 0.0);
}

} // namespace scree
