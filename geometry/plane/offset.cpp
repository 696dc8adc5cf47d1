// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/error.h"
#include "geometry/plane/region_tools.h"

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_set_2.h>
#include <CGAL/minkowski_sum_2.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace scree {

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Polygon = CGAL::Polygon_2<Kernel>;
using PolygonWithHoles = CGAL::Polygon_with_holes_2<Kernel>;
using PolygonSet = CGAL::Polygon_set_2<Kernel>;

constexpr int sides = 32; // 1 / cos(pi / 32) - 1 = 0.0048

/// A regular polygon around the origin; its vertices lie at `radius`.
Polygon disk(double radius) {
    Polygon polygon;
    for (int i = 0; i < sides; ++i) {
        const double angle = 2 * pi * (i + 0.5) / sides;
        polygon.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return polygon;
}

Polygon polygon_of(const Ring& ring, bool reversed) {
    Polygon polygon;
    for (const Vec2& v : ring)
        polygon.push_back({v.x, v.y});
    if (reversed)
        polygon.reverse_orientation();
    return polygon;
}

/// Outer rings with the holes that lie directly in them.
std::vector<PolygonWithHoles> parts_of(const std::vector<Ring>& rings) {
    PolygonSet set;
    std::vector<Polygon> outer, holes;
    for (const Ring& ring : rings)
        (signed_area(ring) > 0 ? outer : holes).push_back(polygon_of(ring, signed_area(ring) < 0));
    // By the even-odd rule, since parts may lie inside of holes of others.
    for (const Polygon& polygon : outer)
        set.symmetric_difference(polygon);
    for (const Polygon& polygon : holes)
        set.symmetric_difference(polygon);
    std::vector<PolygonWithHoles> parts;
    set.polygons_with_holes(std::back_inserter(parts));
    return parts;
}

/// The part without those holes that the disk cannot enter, which the sum fills. CGAL (5.5 to 6.0)
/// drops them itself, but where there are several it reads freed memory: Hole_filter_2 keeps
/// iterators into the deque that it erases from.
PolygonWithHoles without_small_holes(const PolygonWithHoles& part, const Polygon& disk_polygon) {
    const CGAL::Bbox_2 least = disk_polygon.bbox();
    PolygonWithHoles kept(part.outer_boundary());
    for (auto hole = part.holes_begin(); hole != part.holes_end(); ++hole) {
        const CGAL::Bbox_2 box = hole->bbox();
        if (box.xmax() - box.xmin() >= least.xmax() - least.xmin() &&
            box.ymax() - box.ymin() >= least.ymax() - least.ymin())
            kept.add_hole(*hole);
    }
    return kept;
}

PolygonSet grow(const std::vector<PolygonWithHoles>& parts, const Polygon& disk_polygon) {
    PolygonSet set;
    for (const PolygonWithHoles& part : parts)
        set.join(CGAL::minkowski_sum_2(without_small_holes(part, disk_polygon), disk_polygon));
    return set;
}

Ring ring_of(const Polygon& polygon) {
    Ring ring;
    for (auto v = polygon.vertices_begin(); v != polygon.vertices_end(); ++v)
        ring.emplace_back(CGAL::to_double(v->x()), CGAL::to_double(v->y()));
    return ring;
}

} // namespace

Region offset(const Region& region, double margin) {
    if (!std::isfinite(margin))
        throw Error("the margin is not finite");
    if (margin == 0)
        return region;
    std::vector<PolygonWithHoles> parts = parts_of(region.rings);
    PolygonSet result;
    if (margin > 0) {
        result = grow(parts, disk(margin / std::cos(pi / sides)));
    } else {
        Box2 box = bounds(region);
        box.min += Vec2(margin * 2);
        box.max -= Vec2(margin * 2);
        Polygon frame;
        for (const Vec2& v :
             {box.min, Vec2(box.max.x, box.min.y), box.max, Vec2(box.min.x, box.max.y)})
            frame.push_back({v.x, v.y});
        PolygonSet outside(frame);
        for (const PolygonWithHoles& part : parts)
            outside.difference(part);
        parts.clear();
        outside.polygons_with_holes(std::back_inserter(parts));
        result = PolygonSet(frame);
        result.difference(grow(parts, disk(-margin)));
    }
    parts.clear();
    result.polygons_with_holes(std::back_inserter(parts));
    std::vector<Ring> rings;
    for (const PolygonWithHoles& part : parts) {
        rings.push_back(ring_of(part.outer_boundary()));
        for (auto hole = part.holes_begin(); hole != part.holes_end(); ++hole)
            rings.push_back(ring_of(*hole));
    }
    if (rings.empty())
        throw Error(fmt::format("a margin of {} m leaves nothing of the region", margin));
    return triangulate(std::move(rings));
}

} // namespace scree
