// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "geometry/mesh/nearest_surface.h"
#include "geometry/mesh/side_normals.h"
#include "tests/support/component_checks.h"

#include <gtest/gtest.h>

namespace scree {
namespace {

/// A sharp spike: a pyramid on a small square.
Mesh spike() {
    Mesh mesh;
    mesh.positions = {{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}, {0, 20, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {1, 0, 4}, {2, 1, 4}, {3, 2, 4}, {0, 3, 4}};
    return mesh;
}

TEST(SideNormals, TellTheSideAtFacetsEdgesAndCorners) {
    const Mesh mesh = spike();
    ASSERT_TRUE(inspect(mesh).closed());
    ASSERT_GT(volume(mesh), 0);
    const NearestSurface surface(mesh);
    const SideNormals sides(mesh);
    Random random(1, Purpose::fibre_place, 0);
    int at_edges = 0;
    for (int i = 0; i < 20000; ++i) {
        const Imath::V3d p(random.uniform() * 4 - 2, random.uniform() * 24 - 2,
                           random.uniform() * 4 - 2);
        const NearestSurface::Point near = surface.nearest(p);
        const Vec3 way = Vec3(p - near.position);
        // Inside of the spike by its closed form.
        const double half = 1 - p.y / 20;
        const bool inside = p.y > 0 && std::max(std::abs(p.x), std::abs(p.z)) < half;
        if (near.distance < 1e-5)
            continue;
        EXPECT_EQ(way.dot(sides.at(near.triangle, Vec3(near.position))) < 0, inside) << p;
        at_edges += std::abs(std::abs(near.position.x) - std::abs(near.position.z)) < 1e-6 ? 1 : 0;
        EXPECT_NEAR(winding_number(mesh, p), inside ? 1 : 0, 1e-9);
    }
    EXPECT_GT(at_edges, 2000);
}

TEST(SideNormals, AreNotMisledByATriangleWithoutArea) {
    Mesh mesh = spike();
    // A vertex on an edge, which splits one of the facets there and leaves a sliver at the other.
    mesh.positions.push_back({0, 0, -1});
    mesh.triangles = {{0, 5, 2}, {5, 1, 2}, {0, 2, 3}, {0, 1, 5},
                      {1, 0, 4}, {2, 1, 4}, {3, 2, 4}, {0, 3, 4}};
    const SideNormals sides(mesh);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const Vec3 normal = sides.at(t, Vec3(0, 0, -1));
        if (t == 0 || t == 1 || t == 3 || t == 4) {
            EXPECT_GT(normal.dot(Vec3(0, -0.1F, -0.1F)), 0) << t;
            EXPECT_LT(normal.dot(Vec3(0, 0.1F, 0.1F)), 0) << t;
        }
    }
}

TEST(WindingNumber, CountsAllShellsAndTheirTurn) {
    Mesh twice = tests::component_mesh("sphere", {{"radius", 1.0}});
    EXPECT_NEAR(winding_number(twice, {0, 1, 0}), 1, 1e-6);
    EXPECT_NEAR(winding_number(twice, {0, 2.5, 0}), 0, 1e-6);
    for (auto& t : twice.triangles)
        std::swap(t[0], t[1]);
    EXPECT_NEAR(winding_number(twice, {0, 1, 0}), -1, 1e-6);
}

} // namespace
} // namespace scree
