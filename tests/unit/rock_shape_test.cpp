// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/rock/geodesic_sphere.h"
#include "geometry/rock/rock.h"
#include "geometry/rock/rock_params.h"
#include "geometry/rock/solid_noise.h"

#include "tests/support/rocks.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace scree {

namespace {

/// Six times the volume of the tetrahedron of a triangle and the origin.
double volume_from_origin(const std::vector<WideVec3>& p, const Mesh::Triangle& t) {
    return p[t[0]] ^ p[t[1]].cross(p[t[2]]);
}

WideVec3 half_box(const std::vector<WideVec3>& vertices) {
    Imath::Box3d box;
    for (const WideVec3& v : vertices)
        box.extendBy(v);
    return box.size() * 0.5;
}

double area_of(const std::vector<WideVec3>& p, const std::vector<Mesh::Triangle>& triangles) {
    double area = 0;
    for (const Mesh::Triangle& t : triangles)
        area += (p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).length() / 2;
    return area;
}

double volume_of(const std::vector<WideVec3>& p, const std::vector<Mesh::Triangle>& triangles) {
    double volume = 0;
    for (const Mesh::Triangle& t : triangles)
        volume += volume_from_origin(p, t) / 6;
    return volume;
}

} // namespace

TEST(GeodesicSphere, HasEvenTrianglesThatFaceOutwards) {
    for (const int n : {1, 2, 5, 16}) {
        const auto sphere = geodesic_sphere(n);
        EXPECT_EQ(sphere->triangles.size(), std::size_t(20 * n * n));
        EXPECT_EQ(sphere->directions.size(), std::size_t(10 * n * n + 2));
        double shortest = 10;
        double longest = 0;
        for (const Mesh::Triangle& t : sphere->triangles) {
            EXPECT_GT(volume_from_origin(sphere->directions, t), 0);
            for (unsigned k = 0; k < 3; ++k) {
                const double edge =
                    (sphere->directions[t[k]] - sphere->directions[t[(k + 1) % 3]]).length();
                shortest = std::min(shortest, edge);
                longest = std::max(longest, edge);
            }
        }
        EXPECT_LT(longest, 1.5 * shortest);
        EXPECT_LT(shortest, sphere->edge);
        EXPECT_GT(longest, 0.8 * sphere->edge);
    }
}

TEST(GeodesicSphere, UvsLieInTheSquareAndNoTriangleIsTurnedOver) {
    for (const int n : {3, 8, 17}) {
        const auto sphere = geodesic_sphere(n);
        double area = 0;
        for (std::size_t i = 0; i < sphere->triangles.size(); ++i) {
            std::array<Vec2, 3> uv;
            for (unsigned k = 0; k < 3; ++k) {
                const std::uint32_t corner = sphere->corner_triangles[i][k];
                EXPECT_EQ(sphere->direction_of_corner[corner], sphere->triangles[i][k]);
                uv[k] = Vec2(sphere->uvs[corner]);
                EXPECT_GE(std::min(uv[k].x, uv[k].y), -1e-6);
                EXPECT_LE(std::max(uv[k].x, uv[k].y), 1 + 1e-6);
            }
            const double turn = cross(uv[1] - uv[0], uv[2] - uv[0]);
            EXPECT_LT(turn, 1e-9) << i; // x to the right and z up: seen from below
            area -= turn / 2;
        }
        // The square, but for the rim that triangles across a seam need.
        EXPECT_NEAR(area, 1, 3.0 / n);
    }
}

TEST(SolidNoise, HasNoMeanTheStatedSpreadAndNoJumps) {
    Random random(1, Purpose::test);
    double sum = 0;
    double squares = 0;
    constexpr int count = 40000;
    for (int i = 0; i < count; ++i) {
        const WideVec3 p(random.uniform(-50, 50), random.uniform(-50, 50), random.uniform(-50, 50));
        const double here = gradient_noise(p, 5);
        sum += here;
        squares += here * here;
        EXPECT_LT(std::abs(here), 1.3);
        EXPECT_NEAR(gradient_noise(p + WideVec3(1e-6, -1e-6, 1e-6), 5), here, 1e-4);
        EXPECT_LT(std::abs(faceted_noise(p, 5)), 2);
    }
    // The standard error of the mean is 0.27 / 200.
    EXPECT_NEAR(sum / count, 0, 5 * 0.27 / 200);
    EXPECT_NEAR(std::sqrt(squares / count), 0.27, 0.02);
}

// Every triangle's corners turn counter-clockwise about the origin, as those of the sphere do: the
// mesh is the graph of a function over the sphere, so that it is closed, turned outwards and never
// meets itself.
TEST(Rock, IsTheGraphOfARadiusAtExtremeParameters) {
    for (std::uint64_t i = 0; i < 600; ++i) {
        const Rock rock(tests::extreme_rock(i));
        for (const int level : {4, 8}) {
            const std::vector<WideVec3> vertices = rock.vertices(level);
            for (const Mesh::Triangle& t : geodesic_sphere(level)->triangles)
                ASSERT_GT(volume_from_origin(vertices, t), 0) << i << " at level " << level;
        }
    }
}

TEST(Rock, MeshIsClosedWithUvsAndUnitNormals) {
    const Mesh mesh = rock_mesh(Rock(RockSettings{.seed = 3}).vertices(8), 8);
    const MeshFacts facts = inspect(mesh);
    EXPECT_TRUE(facts.closed());
    EXPECT_TRUE(facts.finite);
    EXPECT_EQ(facts.degenerate_triangles, 0U);
    EXPECT_GT(volume(mesh), 0);
    EXPECT_EQ(mesh.uvs.size(), mesh.positions.size());
    for (const Vec3& normal : mesh.normals)
        EXPECT_NEAR(normal.length(), 1, 1e-5);
}

TEST(Rock, HasTheAxesItWasGiven) {
    for (std::uint64_t i = 0; i < 100; ++i) {
        RockSettings settings{.seed = i};
        settings.b_over_a = 0.4 + 0.006 * double(i);
        settings.c_over_a = 0.5 * settings.b_over_a;
        const WideVec3 half = half_box(Rock(settings).vertices(8));
        EXPECT_NEAR(half.x, 1, 0.1);
        EXPECT_NEAR(half.z, settings.b_over_a, 0.1);
        EXPECT_NEAR(half.y, settings.c_over_a, 0.1);
    }
}

// Spheres have the least surface for their volume: wear must come nearer to them.
TEST(Rock, WearMakesRocksRounder) {
    const auto sphericity = [](double wear) {
        double sum = 0;
        for (std::uint64_t i = 0; i < 60; ++i) {
            const std::vector<WideVec3> p =
                Rock(RockSettings{.b_over_a = 1, .c_over_a = 1, .wear = wear, .seed = i})
                    .vertices(12);
            const auto& triangles = geodesic_sphere(12)->triangles;
            sum += std::cbrt(36 * pi * std::pow(volume_of(p, triangles), 2)) /
                   area_of(p, triangles) / 60;
        }
        return sum;
    };
    const double fresh = sphericity(0);
    const double used = sphericity(0.5);
    const double pebble = sphericity(1);
    EXPECT_LT(fresh + 0.02, used);
    EXPECT_LT(used + 0.01, pebble);
    EXPECT_GT(pebble, 0.95);
}

TEST(Rock, LevelsOfDetailAgree) {
    const auto finest = geodesic_sphere(64);
    double square_4 = 0;
    double square_16 = 0;
    constexpr int rocks = 12;
    for (std::uint64_t i = 0; i < rocks; ++i) {
        const Rock rock(RockSettings{.seed = i});
        for (const auto& [level, square] : {std::pair(4, &square_4), {16, &square_16}}) {
            const double edge = geodesic_sphere(level)->edge;
            double sum = 0;
            for (const WideVec3& d : finest->directions)
                sum += (rock.surface(d, 2 * edge) - rock.surface(d, 2 * finest->edge)).length2();
            *square += sum / double(finest->directions.size()) / rocks;
        }
    }
    // Of the longest axis, which is 2.
    EXPECT_LT(std::sqrt(square_4) / 2, 0.015);
    EXPECT_LT(std::sqrt(square_16) / 2, 0.005);
}

TEST(Rock, SameSeedSameRock) {
    const std::vector<WideVec3> once = Rock(RockSettings{.seed = 9}).vertices(6);
    EXPECT_EQ(once, Rock(RockSettings{.seed = 9}).vertices(6));
    EXPECT_NE(once, Rock(RockSettings{.seed = 10}).vertices(6));
}

} // namespace scree
