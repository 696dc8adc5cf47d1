// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh/medial_balls.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Delaunay_triangulation_cell_base_with_circumcenter_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

namespace scree {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<std::size_t, Kernel>;
using CellBase = CGAL::Delaunay_triangulation_cell_base_with_circumcenter_3<Kernel>;
using Triangulation =
    CGAL::Delaunay_triangulation_3<Kernel,
                                   CGAL::Triangulation_data_structure_3<VertexBase, CellBase>>;

Imath::V3d circumcentre(Triangulation::Cell_handle cell) {
    const Kernel::Point_3& p = cell->circumcenter();
    return {p.x(), p.y(), p.z()};
}

} // namespace

std::vector<Ball> inner_poles(std::span<const Vec3> points, std::span<const Vec3> normals) {
    std::vector<std::pair<Kernel::Point_3, std::size_t>> numbered;
    numbered.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        numbered.emplace_back(
            Kernel::Point_3(double(points[i].x), double(points[i].y), double(points[i].z)), i);
    const Triangulation triangulation(numbered.begin(), numbered.end());
    std::vector<Ball> poles;
    if (triangulation.dimension() < 3)
        return poles;
    std::vector<Triangulation::Cell_handle> cells;
    for (const auto vertex : triangulation.finite_vertex_handles()) {
        const Imath::V3d point(points[vertex->info()]);
        const Imath::V3d normal(normals[vertex->info()]);
        cells.clear();
        triangulation.finite_incident_cells(vertex, std::back_inserter(cells));
        double farthest2 = 0;
        Imath::V3d pole;
        for (const Triangulation::Cell_handle cell : cells) {
            const Imath::V3d centre = circumcentre(cell);
            const Imath::V3d to = centre - point;
            if (to.dot(normal) < 0 && to.length2() > farthest2) {
                farthest2 = to.length2();
                pole = centre;
            }
        }
        if (farthest2 > 0)
            poles.push_back({Vec3(pole), static_cast<float>(std::sqrt(farthest2))});
    }
    return poles;
}

} // namespace scree
