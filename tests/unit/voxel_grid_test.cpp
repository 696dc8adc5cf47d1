// SPDX-License-Identifier: GPL-3.0-or-later
// Voxels inside a mesh, against the solid angle of the mesh at their centres.
#include "core/error.h"
#include "geometry/mesh/voxel_grid.h"
#include "tests/support/component_checks.h"

#include <gtest/gtest.h>

namespace scree {
namespace {

using Vec3d = Imath::V3d;
using tests::component_mesh;

// The winding number of the surface around a point (van Oosterom & Strackee 1983).
double winding_number(const Mesh& mesh, const Vec3d& p) {
    double sum = 0;
    for (const Mesh::Triangle& t : mesh.triangles) {
        const Vec3d a = Vec3d(mesh.positions[t[0]]) - p, b = Vec3d(mesh.positions[t[1]]) - p,
                    c = Vec3d(mesh.positions[t[2]]) - p;
        const double la = a.length(), lb = b.length(), lc = c.length();
        sum += 2 * std::atan2(a.dot(b.cross(c)),
                              la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
    }
    return sum / (4 * pi);
}

void compare_to_winding_numbers(const Mesh& mesh, int longest) {
    ASSERT_TRUE(inspect(mesh).closed());
    const VoxelGrid grid = voxel_grid(mesh, longest);
    const std::vector<std::uint8_t> inside = voxels_inside(mesh, grid);
    std::size_t held = 0;
    for (int k = 0; k < grid.count[2]; ++k)
        for (int j = 0; j < grid.count[1]; ++j)
            for (int i = 0; i < grid.count[0]; ++i) {
                const double winding = winding_number(mesh, grid.centre(i, j, k));
                held += inside[grid.index(i, j, k)];
                if (std::abs(winding - std::round(winding)) > 1e-3)
                    continue; // on the surface
                ASSERT_EQ(inside[grid.index(i, j, k)] != 0, std::abs(winding) > 0.5)
                    << mesh.name << " at " << i << ", " << j << ", " << k;
            }
    EXPECT_NEAR(double(held) * std::pow(grid.side, 3) / std::abs(volume(mesh)), 1, 0.1);
}

TEST(VoxelGrid, FitsTheBoundingBox) {
    const Mesh mesh = component_mesh("box", {{"width", 0.4}, {"height", 0.2}, {"depth", 0.1}});
    const VoxelGrid grid = voxel_grid(mesh, 16);
    EXPECT_EQ(grid.count, (std::array<int, 3>{16, 8, 4}));
    EXPECT_NEAR(grid.side, 0.025, 1e-8);
    EXPECT_LT((grid.centre(0, 0, 0) - (Vec3d(bounds(mesh).min) + Vec3d(0.0125))).length(), 1e-7);
    EXPECT_EQ(voxel_grid(component_mesh("plane"), 10).count, (std::array<int, 3>{10, 1, 10}));
    Mesh point;
    point.positions = {Vec3(1.0F), Vec3(1.0F)};
    EXPECT_THROW(voxel_grid(point, 10), Error);
}

TEST(VoxelGrid, InsideIsWhereTheWindingNumberIsNotZero) {
    compare_to_winding_numbers(component_mesh("sphere", {{"segments", std::int64_t{24}}}), 17);
    compare_to_winding_numbers(component_mesh("torus", {{"segments", std::int64_t{24}}}), 20);
    compare_to_winding_numbers(component_mesh("star"), 14);
}

// Sides and edges of the triangles pass through the centres of voxels.
TEST(VoxelGrid, EdgesThroughCentresAreDecidedOnce) {
    const Mesh box = component_mesh("box", {{"width", 1.0}, {"rounding", 0.0}});
    for (const int longest : {1, 2, 7, 16})
        for (const std::uint8_t v : voxels_inside(box, voxel_grid(box, longest)))
            EXPECT_EQ(v, 1);
    VoxelGrid wide = voxel_grid(box, 8); // half a voxel larger: voxel centres lie on all faces
    wide.corner -= Vec3d(wide.side / 2);
    wide.count = {9, 9, 9};
    std::size_t held = 0;
    for (const std::uint8_t v : voxels_inside(box, wide))
        held += v;
    EXPECT_EQ(held, 512U) << "of two opposite sides one belongs to it";
}

TEST(VoxelGrid, EitherSideMayBeTheFrontAndPartsMayOverlap) {
    Mesh mesh = component_mesh("sphere");
    const VoxelGrid grid = voxel_grid(mesh, 20);
    const std::vector<std::uint8_t> inside = voxels_inside(mesh, grid);
    Mesh turned = mesh;
    for (Mesh::Triangle& t : turned.triangles)
        std::swap(t[0], t[1]);
    EXPECT_EQ(voxels_inside(turned, grid), inside);
    Mesh twice = mesh;
    append(twice, mesh);
    EXPECT_EQ(voxels_inside(twice, grid), inside);
}

} // namespace
} // namespace scree
