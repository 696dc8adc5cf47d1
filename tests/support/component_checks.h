// SPDX-License-Identifier: GPL-3.0-or-later
// Component meshes and checks of them, for tests.
#pragma once

#include "geometry/mesh/mesh.h"
#include "shapes/table.h"
#include "tests/support/plugin_params.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace scree::tests {

/// The mesh of a component plug-in from the given values and defaults.
inline Mesh component_mesh(const std::string& name,
                           const std::map<std::string, Value>& values = {}) {
    return make(component_table(), name, values);
}

/// Checks what holds for every component: a valid closed mesh (but for the open ones) with unit
/// normals and finite UVs, standing on the ground and centred on the y axis.
inline void expect_sound(const Mesh& mesh, const std::string& what) {
    SCOPED_TRACE(what);
    ASSERT_FALSE(mesh.triangles.empty());
    const MeshFacts facts = inspect(mesh);
    EXPECT_TRUE(facts.finite);
    EXPECT_EQ(facts.degenerate_triangles, 0U);
    EXPECT_EQ(facts.non_manifold_edges, 0U);
    if (mesh.name != "plane" && mesh.name != "terrain") {
        EXPECT_EQ(facts.boundary_edges, 0U);
        EXPECT_GT(volume(mesh), 0);
    }
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    ASSERT_EQ(mesh.uvs.size(), mesh.positions.size());
    float worst = 0;
    for (const Vec3& n : mesh.normals)
        worst = std::max(worst, std::isfinite(n.length()) ? std::abs(n.length() - 1) : 1e9F);
    EXPECT_LT(worst, 1e-4F);
    for (const Vec2f& uv : mesh.uvs)
        ASSERT_TRUE(std::isfinite(uv.x) && std::isfinite(uv.y));
    const Box3 box = bounds(mesh);
    const float tolerance = 1e-5F * box.size().length();
    EXPECT_EQ(box.min.y, 0.0F);
    EXPECT_NEAR(box.center().x, 0.0F, tolerance);
    EXPECT_NEAR(box.center().z, 0.0F, tolerance);
}

/// The area of triangles whose shading normals differ by more than 60 degrees from the geometric
/// one.
inline double area_of_wrong_normals(const Mesh& mesh) {
    double sum = 0;
    for (const Mesh::Triangle& t : mesh.triangles) {
        const Vec3& a = mesh.positions[t[0]];
        const Vec3 face = (mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a);
        for (const std::uint32_t i : t)
            if (face.normalized().dot(mesh.normals[i]) < 0.5F) {
                sum += 0.5 * double(face.length());
                break;
            }
    }
    return sum;
}

} // namespace scree::tests
