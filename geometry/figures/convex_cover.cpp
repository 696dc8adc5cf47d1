// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/figures/convex_cover.h"

#include "geometry/plane/convex_hull.h"

#include <algorithm>
#include <limits>
#include <map>

namespace scree {

namespace {

constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

/// The triangulation as half-edges, so that a diagonal is taken out in constant time.
struct HalfEdges {
    struct Edge {
        std::uint32_t origin, next, previous, twin;
    };
    const std::vector<Vec2>& vertices;
    std::vector<Edge> edges;

    explicit HalfEdges(const Region& region) : vertices(region.vertices) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> by_ends;
        for (const auto& t : region.triangles) {
            const auto first = static_cast<std::uint32_t>(edges.size());
            for (std::uint32_t i = 0; i < 3; ++i) {
                edges.push_back({t[i], first + (i + 1) % 3, first + (i + 2) % 3, none});
                const auto twin = by_ends.find({t[(i + 1) % 3], t[i]});
                if (twin != by_ends.end()) {
                    edges.back().twin = twin->second;
                    edges[twin->second].twin = first + i;
                }
                by_ends[{t[i], t[(i + 1) % 3]}] = first + i;
            }
        }
    }

    const Vec2& origin(std::uint32_t e) const { return vertices[edges[e].origin]; }

    /// Whether the corner at the origin of e stays convex when e and its twin are gone.
    bool stays_convex(std::uint32_t e) const {
        const std::uint32_t out = edges[edges[e].twin].next;
        const Vec2& before = origin(edges[e].previous);
        const Vec2& after = origin(edges[out].next);
        return cross(origin(e) - before, after - origin(e)) >= 0;
    }

    void remove(std::uint32_t e) {
        const std::uint32_t t = edges[e].twin;
        for (const auto& [from, to] : {std::pair(edges[e].previous, edges[t].next),
                                       std::pair(edges[t].previous, edges[e].next)}) {
            edges[from].next = to;
            edges[to].previous = from;
        }
        edges[e].next = edges[t].next = none;
    }
};

Ring without_straight_corners(const Ring& ring) {
    Ring result;
    const std::size_t n = ring.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 in = ring[i] - ring[(i + n - 1) % n], out = ring[(i + 1) % n] - ring[i];
        if (cross(in, out) > 1e-12 * in.length() * out.length())
            result.push_back(ring[i]);
    }
    return result;
}

/// Removes the points that a cut through a corner leaves, which differ by rounding only and whose
/// edges have no meaningful direction.
Ring without_near_points(const Ring& ring, double distance) {
    Ring result;
    for (const Vec2& v : ring)
        if (result.empty() ||
            ((v - result.back()).length() > distance && (v - result.front()).length() > distance))
            result.push_back(v);
    return result;
}

bool holds(const Ring& convex, const Ring& other, double tolerance) {
    for (std::size_t i = 0; i < convex.size(); ++i) {
        const Vec2& a = convex[i];
        const Vec2 along = (convex[(i + 1) % convex.size()] - a).normalized();
        for (const Vec2& v : other)
            if (cross(along, v - a) < -tolerance)
                return false;
    }
    return true;
}

struct Segment {
    Vec2 from, to;
};

/// Whether the segment enters the convex polygon deeper than the tolerance.
bool enters(const Segment& s, const Ring& convex, double tolerance) {
    double low = 0, high = 1;
    for (std::size_t i = 0; i < convex.size(); ++i) {
        const Vec2& a = convex[i];
        const Vec2 along = (convex[(i + 1) % convex.size()] - a).normalized();
        const double f = cross(along, s.from - a) - tolerance;
        const double t = cross(along, s.to - a) - tolerance;
        if (f <= 0 && t <= 0)
            return false;
        if (f < 0)
            low = std::max(low, f / (f - t));
        if (t < 0)
            high = std::min(high, f / (f - t));
    }
    return low < high;
}

/// The largest part of `around` that a straight cut keeps, with the seed on one side and the
/// segment on the other. One of the seed's edges or the segment itself gives the direction
/// (separating axes of two convex sets).
Ring cut_off(const Ring& around, const Ring& seed, const Segment& s, double tolerance) {
    Ring best;
    double best_area = -1;
    const auto consider = [&](const Vec2& normal) {
        const double offset = std::min(normal.dot(s.from), normal.dot(s.to));
        for (const Vec2& v : seed)
            if (normal.dot(v) > offset + tolerance)
                return;
        Ring kept = cut(around, normal, offset);
        const double size = signed_area(kept);
        if (size > best_area) {
            best_area = size;
            best = std::move(kept);
        }
    };
    const Vec2 along = (s.to - s.from).normalized();
    consider({along.y, -along.x});
    consider({-along.y, along.x});
    for (std::size_t i = 0; i < seed.size(); ++i) {
        const Vec2 edge = (seed[(i + 1) % seed.size()] - seed[i]).normalized();
        consider({edge.y, -edge.x});
    }
    return best_area < 0 ? seed : best;
}

/// Joins pairs of parts into their convex hull, the largest first, where that lies in the region:
/// two tips of a star, say, with the area between them.
std::vector<Ring> joined(std::vector<Ring> parts, const std::vector<Segment>& outline,
                         double tolerance) {
    struct Pair {
        std::size_t first, second;
        Ring hull;
        double area;
    };
    std::vector<Pair> pairs;
    const auto add_pairs = [&](std::size_t second) {
        for (std::size_t first = 0; first < second; ++first) {
            if (parts[first].empty())
                continue;
            Ring points = parts[first];
            points.insert(points.end(), parts[second].begin(), parts[second].end());
            Ring hull = convex_hull(std::move(points));
            if (std::ranges::none_of(
                    outline, [&](const Segment& s) { return enters(s, hull, tolerance); })) {
                const double size = signed_area(hull);
                pairs.push_back({first, second, std::move(hull), size});
            }
        }
    };
    for (std::size_t i = 0; i < parts.size(); ++i)
        add_pairs(i);
    while (!pairs.empty()) {
        const Pair best = *std::ranges::max_element(pairs, {}, &Pair::area);
        parts[best.first].clear();
        parts[best.second].clear();
        std::erase_if(pairs, [&](const Pair& p) {
            return parts[p.first].empty() || parts[p.second].empty();
        });
        parts.push_back(best.hull);
        add_pairs(parts.size() - 1);
    }
    std::erase_if(parts, [](const Ring& part) { return part.size() < 3; });
    return parts;
}

Ring grown(const Ring& seed, std::vector<Segment> outline, const Box2& box) {
    const double tolerance = 1e-9 * box.size().length();
    const Vec2 centre = bounds({.rings = {seed}, .vertices = {}, .triangles = {}}).center();
    std::ranges::stable_sort(
        outline, {}, [&](const Segment& s) { return segment_distance(centre, s.from, s.to); });
    Ring result = {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
    for (const Segment& s : outline)
        if (enters(s, result, tolerance))
            result = without_near_points(cut_off(result, seed, s, tolerance), tolerance);
    return result;
}

} // namespace

Ring cut(const Ring& convex, const Vec2& normal, double offset) {
    Ring result;
    for (std::size_t i = 0, j = convex.size() - 1; i < convex.size(); j = i++) {
        const double from = normal.dot(convex[j]) - offset, to = normal.dot(convex[i]) - offset;
        if ((from < 0) != (to < 0) && from != 0 && to != 0)
            result.push_back(convex[j] + (convex[i] - convex[j]) * (from / (from - to)));
        if (to <= 0)
            result.push_back(convex[i]);
    }
    return result;
}

std::vector<Ring> convex_partition(const Region& region) {
    HalfEdges mesh(region);
    for (std::uint32_t e = 0; e < mesh.edges.size(); ++e) {
        const std::uint32_t twin = mesh.edges[e].twin;
        if (mesh.edges[e].next != none && twin != none && e < twin && mesh.stays_convex(e) &&
            mesh.stays_convex(twin))
            mesh.remove(e);
    }
    std::vector<Ring> parts;
    std::vector<bool> seen(mesh.edges.size());
    for (std::uint32_t e = 0; e < mesh.edges.size(); ++e) {
        if (seen[e] || mesh.edges[e].next == none)
            continue;
        Ring ring;
        for (std::uint32_t i = e; !seen[i]; i = mesh.edges[i].next) {
            seen[i] = true;
            ring.push_back(mesh.origin(i));
        }
        parts.push_back(without_straight_corners(ring));
    }
    return parts;
}

std::vector<Ring> convex_cover(const Region& region) {
    std::vector<Segment> outline;
    for (const Ring& ring : region.rings)
        for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
            outline.push_back({ring[j], ring[i]});
    const Box2 box = bounds(region);
    struct Part {
        Ring seed, whole;
    };
    std::vector<Part> parts;
    const double tolerance = 1e-9 * box.size().length();
    for (Ring& seed : joined(convex_partition(region), outline, tolerance)) {
        Ring whole = without_straight_corners(grown(seed, outline, box));
        parts.push_back({std::move(seed), std::move(whole)});
    }
    std::ranges::stable_sort(parts, [](const Part& a, const Part& b) {
        return signed_area(a.whole) > signed_area(b.whole);
    });
    std::vector<Ring> cover;
    for (const Part& part : parts)
        if (std::ranges::none_of(
                cover, [&](const Ring& other) { return holds(other, part.seed, tolerance); }))
            cover.push_back(part.whole);
    return cover;
}

Ring simplify_inward(const Ring& convex, double tolerance) {
    // Greedily the longest chord that cuts off no point farther than the tolerance from it.
    const std::size_t n = convex.size();
    Ring result;
    for (std::size_t i = 0; i < n;) {
        result.push_back(convex[i]);
        std::size_t next = i + 1;
        for (std::size_t end = i + 2; end <= n; ++end) {
            const Vec2& to = convex[end % n];
            bool near = true;
            for (std::size_t k = i + 1; k < end && near; ++k)
                near = segment_distance(convex[k], convex[i], to) <= tolerance;
            if (!near)
                break;
            next = end;
        }
        i = next;
    }
    return result.size() >= 3 ? result : convex;
}

Ring kernel(const Region& region) {
    const Box2 box = bounds(region);
    Ring result = {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
    for (const Ring& ring : region.rings) {
        for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
            const Vec2 along = (ring[i] - ring[j]).normalized();
            const Vec2 outward(along.y, -along.x);
            result = cut(result, outward, outward.dot(ring[j]));
            if (result.size() < 3)
                return {};
        }
    }
    return signed_area(result) > 1e-9 * area(region) ? result : Ring{};
}

} // namespace scree
