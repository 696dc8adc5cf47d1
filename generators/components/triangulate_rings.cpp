// SPDX-License-Identifier: GPL-3.0-or-later
// The components' door to CGAL.
#include "generators/components/extrude.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <optional>

namespace scree {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<std::optional<bool>, Kernel,
                                              CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Delaunay = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure>;

// Floods from outside; crossing a ring's edge changes sides.
void mark_inside(Delaunay& delaunay) {
    std::vector<std::pair<Delaunay::Face_handle, bool>> open{{delaunay.infinite_face(), false}};
    while (!open.empty()) {
        const auto [face, inside] = open.back();
        open.pop_back();
        if (face->info().has_value())
            continue;
        face->info() = inside;
        for (int side = 0; side < 3; ++side)
            open.emplace_back(face->neighbor(side), inside != face->is_constrained(side));
    }
}

} // namespace

Triangulation triangulate_rings(const std::vector<Ring>& rings) try {
    Delaunay delaunay;
    Triangulation out;
    for (const Ring& ring : rings) {
        std::vector<Delaunay::Vertex_handle> handles;
        for (const Vec2& p : ring) {
            handles.push_back(delaunay.insert({p.x, p.y}));
            handles.back()->info() = static_cast<std::uint32_t>(out.vertices.size());
            out.vertices.push_back(p);
        }
        for (std::size_t i = 0; i < handles.size(); ++i)
            delaunay.insert_constraint(handles[i], handles[(i + 1) % handles.size()]);
    }
    mark_inside(delaunay);
    for (const auto& face : delaunay.finite_face_handles())
        if (face->info().value_or(false))
            out.triangles.push_back(
                {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
    return out;
} catch (const Delaunay::Intersection_of_constraints_exception&) {
    return {};
}

} // namespace scree
