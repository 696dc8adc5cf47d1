// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/mesh/mesh.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

namespace scree::tests {

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Surface = CGAL::Surface_mesh<Point>;

/// The mesh as in an STL file: triangles connected only by equal positions.
inline Surface cgal_surface(const Mesh& mesh) {
    const std::vector<std::uint32_t> welded = weld(mesh);
    std::vector<Point> points;
    for (const Vec3& p : mesh.positions)
        points.emplace_back(p.x, p.y, p.z);
    std::vector<std::array<std::size_t, 3>> faces;
    for (const Mesh::Triangle& t : mesh.triangles)
        faces.push_back({welded[t[0]], welded[t[1]], welded[t[2]]});
    EXPECT_TRUE(CGAL::Polygon_mesh_processing::is_polygon_soup_a_polygon_mesh(faces));
    Surface surface;
    CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, faces, surface);
    CGAL::Polygon_mesh_processing::remove_isolated_vertices(surface); // the doubles of seams
    return surface;
}

} // namespace scree::tests
