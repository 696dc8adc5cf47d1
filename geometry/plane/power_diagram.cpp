// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/plane/power_diagram.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

namespace scree {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase =
    CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel,
                                                CGAL::Regular_triangulation_vertex_base_2<Kernel>>;
using FaceBase = CGAL::Regular_triangulation_face_base_2<Kernel>;
using Triangulation =
    CGAL::Regular_triangulation_2<Kernel,
                                  CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;

Triangulation triangulation_of(std::span<const Vec2> sites, std::span<const double> weights) {
    std::vector<std::pair<Kernel::Weighted_point_2, std::uint32_t>> points;
    points.reserve(sites.size());
    for (std::uint32_t i = 0; i < sites.size(); ++i)
        points.emplace_back(
            Kernel::Weighted_point_2({sites[i].x, sites[i].y}, weights.empty() ? 0 : weights[i]),
            i);
    return {points.begin(), points.end()};
}

/// Keeps of the cell the points p with normal . p <= offset, which another site is `beyond`.
void cut(PowerCell& cell, const Vec2& normal, double offset, std::int32_t beyond) {
    Ring ring;
    std::vector<std::int32_t> sides;
    for (std::size_t k = 0; k < cell.ring.size(); ++k) {
        const Vec2& p = cell.ring[k];
        const Vec2& q = cell.ring[(k + 1) % cell.ring.size()];
        const double at_p = (normal ^ p) - offset;
        const double at_q = (normal ^ q) - offset;
        if (at_p <= 0) {
            ring.push_back(p);
            sides.push_back(cell.beyond[k]);
        }
        if ((at_p <= 0) != (at_q <= 0)) {
            ring.push_back(p + (q - p) * (at_p / (at_p - at_q)));
            sides.push_back(at_p <= 0 ? beyond : cell.beyond[k]);
        }
    }
    cell.ring = std::move(ring);
    cell.beyond = std::move(sides);
}

void measure(PowerCell& cell) {
    if (cell.ring.empty())
        return;
    // About the first point, so that cells far from the origin lose no digits.
    const Vec2 origin = cell.ring.front();
    Vec2 moment(0.0, 0.0);
    for (std::size_t k = 0; k < cell.ring.size(); ++k) {
        const Vec2 p = cell.ring[k] - origin;
        const Vec2 q = cell.ring[(k + 1) % cell.ring.size()] - origin;
        const double part = cross(p, q) / 2;
        cell.area += part;
        moment += (p + q) * (part / 3);
    }
    cell.centroid = cell.area > 0 ? origin + moment / cell.area : origin;
}

} // namespace

std::vector<PowerCell> power_diagram(std::span<const Vec2> sites, std::span<const double> weights,
                                     const Ring& domain) {
    const Triangulation triangulation = triangulation_of(sites, weights);
    std::vector<PowerCell> cells(sites.size());
    for (auto v = triangulation.finite_vertices_begin(); v != triangulation.finite_vertices_end();
         ++v) {
        const std::uint32_t i = v->info();
        PowerCell& cell = cells[i];
        cell.ring = domain;
        cell.beyond.assign(domain.size(), PowerCell::border);
        auto around = triangulation.incident_vertices(v);
        const auto first = around;
        if (around != nullptr)
            do {
                if (triangulation.is_infinite(around))
                    continue;
                const std::uint32_t j = around->info();
                const Vec2 apart = sites[j] - sites[i];
                const double more = weights.empty() ? 0 : weights[i] - weights[j];
                const Vec2 middle = (sites[i] + sites[j]) * 0.5;
                cut(cell, apart, (apart ^ middle) + more / 2, static_cast<std::int32_t>(j));
            } while (++around != first && !cell.ring.empty());
        measure(cell);
    }
    return cells;
}

std::vector<std::array<std::uint32_t, 3>> delaunay(std::span<const Vec2> points) {
    const Triangulation triangulation = triangulation_of(points, {});
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (auto f = triangulation.finite_faces_begin(); f != triangulation.finite_faces_end(); ++f)
        triangles.push_back({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info()});
    return triangles;
}

} // namespace scree
