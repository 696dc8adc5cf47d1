// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/region_distance.h"

#include <algorithm>

namespace scree {

namespace {

bool cross_each_other(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    const auto sides_differ = [](const Vec2& p, const Vec2& q, const Vec2& u, const Vec2& v) {
        return (cross(q - p, u - p) > 0) != (cross(q - p, v - p) > 0);
    };
    return sides_differ(a, b, c, d) && sides_differ(c, d, a, b);
}

double distance_of_segments(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
    if (cross_each_other(a, b, c, d))
        return 0;
    return std::min({segment_distance(a, c, d), segment_distance(b, c, d),
                     segment_distance(c, a, b), segment_distance(d, a, b)});
}

// A box that contains all queries: the window and, unless on a torus, the regions that extend
// beyond it.
Box2 frame_of(const PlacedRegions& regions) {
    Box2 frame = bounds(*regions.window.domain);
    if (!regions.window.torus)
        for (const Region& outline : regions.outlines)
            frame.extendBy(bounds(outline));
    return frame;
}

} // namespace

RegionDistance::RegionDistance(const PlacedRegions& regions)
    : regions_(regions), frame_(frame_of(regions)), edges_(edges_of(regions)),
      element_boxes_(boxes_of(regions)), edge_grid_(boxes_of(edges_), frame_, regions.window.torus),
      element_grid_(element_boxes_, frame_, regions.window.torus) {
    first_edge_.assign(regions.outlines.size() + 1, 0);
    for (const Edge& edge : edges_)
        ++first_edge_[edge.element + 1];
    for (std::size_t i = 1; i < first_edge_.size(); ++i)
        first_edge_[i] += first_edge_[i - 1];
}

std::vector<RegionDistance::Edge> RegionDistance::edges_of(const PlacedRegions& regions) {
    std::vector<Edge> edges;
    for (std::uint32_t element = 0; element < regions.outlines.size(); ++element)
        for (const Ring& ring : regions.outlines[element].rings)
            for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
                edges.push_back({ring[j], ring[i], element});
    return edges;
}

std::vector<Box2> RegionDistance::boxes_of(const std::vector<Edge>& edges) {
    std::vector<Box2> boxes(edges.size());
    for (std::size_t i = 0; i < edges.size(); ++i) {
        boxes[i].extendBy(edges[i].a);
        boxes[i].extendBy(edges[i].b);
    }
    return boxes;
}

std::vector<Box2> RegionDistance::boxes_of(const PlacedRegions& regions) {
    std::vector<Box2> boxes(regions.outlines.size());
    for (std::size_t i = 0; i < boxes.size(); ++i)
        boxes[i] = bounds(regions.outlines[i]);
    return boxes;
}

double RegionDistance::operator()(const Vec2& point) const {
    const double distance = edge_grid_.nearest(point, [&](std::uint32_t i, const Vec2& shift) {
        return segment_distance(point - shift, edges_[i].a, edges_[i].b);
    });
    return inside(point) ? -distance : distance;
}

bool RegionDistance::inside(const Vec2& point) const {
    bool found = false;
    element_grid_.visit_at(point, [&](std::uint32_t i, const Vec2& shift) {
        found = found || (element_boxes_[i].intersects(point - shift) &&
                          contains(regions_.outlines[i], point - shift));
    });
    return found;
}

double RegionDistance::to_neighbour(std::uint32_t element) const {
    const std::uint32_t begin = first_edge_[element];
    const std::uint32_t end = first_edge_[element + 1];
    const auto is_self = [&](std::uint32_t edge, const Vec2& shift) {
        return edges_[edge].element == element && shift == Vec2(0, 0);
    };
    // On a torus an outline may have vertices outside the frame, where queries work too.
    double best = edge_grid_.nearest(edges_[begin].a, [&](std::uint32_t i, const Vec2& shift) {
        return is_self(i, shift)
                   ? std::numeric_limits<double>::infinity()
                   : segment_distance(edges_[begin].a - shift, edges_[i].a, edges_[i].b);
    });
    for (std::uint32_t edge = begin; edge < end && std::isfinite(best); ++edge) {
        const Vec2& a = edges_[edge].a;
        const Vec2& b = edges_[edge].b;
        Box2 box;
        box.extendBy(a);
        box.extendBy(b);
        box.min -= Vec2(best, best);
        box.max += Vec2(best, best);
        edge_grid_.visit_box(box, [&](std::uint32_t i, const Vec2& shift) {
            if (!is_self(i, shift))
                best = std::min(
                    best, distance_of_segments(a, b, edges_[i].a + shift, edges_[i].b + shift));
        });
    }
    return best;
}

} // namespace scree
