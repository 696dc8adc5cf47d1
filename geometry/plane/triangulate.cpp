// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/error.h"
#include "geometry/plane/region_tools.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace scree {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Segment = Kernel::Segment_2;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<
    Kernel, CGAL::Triangulation_face_base_with_info_2<int, Kernel>>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
    CGAL::No_constraint_intersection_tag>;

struct Edge {
    std::size_t ring;
    std::size_t index; // from point `index` to the next one
    Vec2 from;
    Vec2 to;

    double low() const { return std::min(from.x, to.x); }
    double high() const { return std::max(from.x, to.x); }
    std::string text() const {
        return fmt::format("edge {} of ring {}, from ({}, {}) to ({}, {})", index, ring, from.x,
                           from.y, to.x, to.y);
    }
};

Point point(const Vec2& v) { return {v.x, v.y}; }

void check_points(const std::vector<Ring>& rings) {
    if (rings.empty())
        throw Error("a region needs at least one ring of points");
    for (std::size_t r = 0; r < rings.size(); ++r) {
        for (std::size_t i = 0; i < rings[r].size(); ++i)
            if (!std::isfinite(rings[r][i].x) || !std::isfinite(rings[r][i].y))
                throw Error(fmt::format("point {} of ring {} is not finite: ({}, {})", i, r,
                                        rings[r][i].x, rings[r][i].y));
        if (rings[r].size() < 3)
            throw Error(fmt::format("ring {} has {} different points in a row, a region needs at "
                                    "least 3",
                                    r, rings[r].size()));
    }
}

void drop_repeated_points(Ring& ring) {
    ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
    while (ring.size() > 1 && ring.front() == ring.back())
        ring.pop_back();
}

/// Exactly, on the given doubles: no two edges share a point except neighbours their vertex.
void check_edges(const std::vector<Ring>& rings) {
    std::vector<Edge> edges;
    for (std::size_t r = 0; r < rings.size(); ++r)
        for (std::size_t i = 0; i < rings[r].size(); ++i)
            edges.push_back({r, i, rings[r][i], rings[r][(i + 1) % rings[r].size()]});
    std::stable_sort(edges.begin(), edges.end(),
                     [](const Edge& a, const Edge& b) { return a.low() < b.low(); });
    const auto follows = [&](const Edge& a, const Edge& b) {
        return a.ring == b.ring && (a.index + 1) % rings[a.ring].size() == b.index;
    };
    const auto folds = [](const Edge& a, const Edge& b) {
        const Point p = point(a.from), q = point(a.to), r = point(b.to);
        return CGAL::collinear(p, q, r) && CGAL::angle(p, q, r) == CGAL::ACUTE;
    };
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const Edge& a = edges[i];
        const Segment segment(point(a.from), point(a.to));
        for (std::size_t j = i + 1; j < edges.size() && edges[j].low() <= a.high(); ++j) {
            const Edge& b = edges[j];
            if (std::max(a.from.y, a.to.y) < std::min(b.from.y, b.to.y) ||
                std::min(a.from.y, a.to.y) > std::max(b.from.y, b.to.y))
                continue;
            const bool wrong =
                follows(a, b)   ? folds(a, b)
                : follows(b, a) ? folds(b, a)
                                : CGAL::do_intersect(segment, Segment(point(b.from), point(b.to)));
            if (!wrong)
                continue;
            const bool in_order = std::pair(a.ring, a.index) < std::pair(b.ring, b.index);
            throw Error(fmt::format("{} crosses or touches {}", (in_order ? a : b).text(),
                                    (in_order ? b : a).text()));
        }
    }
}

/// Marks every face with the number of rings around it, from the outside inwards.
void mark_nesting(Triangulation& triangulation) {
    for (auto face : triangulation.all_face_handles())
        face->info() = -1;
    std::vector<std::pair<Triangulation::Face_handle, int>> border{
        {triangulation.infinite_face(), 0}};
    for (std::size_t next = 0; next < border.size(); ++next) {
        const int depth = border[next].second;
        std::vector<Triangulation::Face_handle> stack{border[next].first};
        while (!stack.empty()) {
            const Triangulation::Face_handle face = stack.back();
            stack.pop_back();
            if (face->info() != -1)
                continue;
            face->info() = depth;
            for (int i = 0; i < 3; ++i) {
                const Triangulation::Face_handle neighbour = face->neighbor(i);
                if (neighbour->info() != -1)
                    continue;
                if (face->is_constrained(i))
                    border.emplace_back(neighbour, depth + 1);
                else
                    stack.push_back(neighbour);
            }
        }
    }
}

} // namespace

Region triangulate(std::vector<Ring> rings) {
    for (Ring& ring : rings)
        drop_repeated_points(ring);
    check_points(rings);
    check_edges(rings);

    Region region;
    Triangulation triangulation;
    std::vector<std::vector<Triangulation::Vertex_handle>> handles(rings.size());
    for (std::size_t r = 0; r < rings.size(); ++r) {
        for (const Vec2& v : rings[r]) {
            const auto handle = triangulation.insert(point(v));
            handle->info() = static_cast<std::uint32_t>(region.vertices.size());
            region.vertices.push_back(v);
            handles[r].push_back(handle);
        }
    }
    for (const auto& ring : handles)
        for (std::size_t i = 0; i < ring.size(); ++i)
            triangulation.insert_constraint(ring[i], ring[(i + 1) % ring.size()]);
    mark_nesting(triangulation);

    for (auto face : triangulation.finite_face_handles())
        if (face->info() % 2 == 1)
            region.triangles.push_back(
                {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});

    for (std::size_t r = 0; r < rings.size(); ++r) {
        Triangulation::Face_handle face;
        int i = 0;
        triangulation.is_edge(handles[r][0], handles[r][1], face, i);
        const bool face_is_left = face->vertex(Triangulation::ccw(i)) == handles[r][0];
        if ((face->info() % 2 == 1) != face_is_left)
            std::reverse(rings[r].begin(), rings[r].end());
    }
    region.rings = std::move(rings);
    return region;
}

} // namespace scree
