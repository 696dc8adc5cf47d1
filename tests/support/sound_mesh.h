// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/mesh/mesh.h"

#include <gtest/gtest.h>

#include <cmath>

namespace scree::tests {

/// Expects what every mesh of the table promises: no bad triangles or edges, closed with its
/// outside outwards unless it is a plane, unit normals and finite texture coordinates at all
/// vertices, and its place: centred on the y axis, the lowest point at y = 0.
inline void expect_sound(const Mesh& mesh, const std::string& what) {
    SCOPED_TRACE(what);
    ASSERT_FALSE(mesh.triangles.empty());
    const MeshFacts facts = inspect(mesh);
    EXPECT_TRUE(facts.finite);
    EXPECT_EQ(facts.degenerate_triangles, 0U);
    EXPECT_EQ(facts.non_manifold_edges, 0U);
    if (mesh.name != "plane") {
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

} // namespace scree::tests
