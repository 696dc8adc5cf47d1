// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of which dropped rocks are made, against closed forms and brute force.
#include "generators/rocks/drop.h"
#include "generators/rocks/lowering_plane.h"
#include "generators/rocks/rock_sizes.h"

#include "core/parallel.h"
#include "core/random.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace scree::rocks {

namespace {

RockSurface rock(std::uint64_t seed, int level = 4) {
    return make_rock_surface(RockSettings{.seed = seed}, level, "rock");
}

Imath::M33d random_turn(Random& random) {
    const WideVec3 x = WideVec3(random.uniform(-1, 1), random.uniform(-1, 1), 1.1).normalized();
    const WideVec3 y = x.cross(WideVec3(random.uniform(-1, 1), 1, 0)).normalized();
    const WideVec3 z = x.cross(y);
    return {x.x, x.y, x.z, y.x, y.y, y.z, z.x, z.y, z.z};
}

Region square(double side) {
    Region region;
    const double h = side / 2;
    region.rings = {{Vec2(-h, -h), Vec2(h, -h), Vec2(h, h), Vec2(-h, h)}};
    return region;
}

} // namespace

TEST(RockFootprint, IsBelowTheUndersideEverywhere) {
    Random random(2, Purpose::test);
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const RockSurface surface = rock(seed);
        std::vector<Vec3> vertices;
        pose_vertices(surface, random_turn(random), 0.5, vertices);
        Footprint under, top;
        const double cell = 0.04;
        rasterise(vertices, surface.triangles, cell, Side::under, under);
        rasterise(vertices, surface.triangles, cell, Side::top, top);
        for (int k = 0; k < 2000; ++k) {
            const Mesh::Triangle& t =
                surface.triangles[random.below(std::uint32_t(surface.triangles.size()))];
            float u = random.uniform_float();
            float v = random.uniform_float();
            if (u + v > 1) {
                u = 1 - u;
                v = 1 - v;
            }
            const Vec3 p = vertices[t[0]] + (vertices[t[1]] - vertices[t[0]]) * u +
                           (vertices[t[2]] - vertices[t[0]]) * v;
            const int i = int(std::floor(double(p.x) / cell + 0.5)) - under.first_x;
            const int j = int(std::floor(double(p.z) / cell + 0.5)) - under.first_z;
            ASSERT_TRUE(i >= 0 && j >= 0 && i < under.width && j < under.depth);
            const auto index = std::size_t(j) * std::size_t(under.width) + std::size_t(i);
            EXPECT_LE(under.heights[index], p.y + 1e-5F);
            EXPECT_GE(top.heights[index], p.y - 1e-5F);
        }
    }
}

TEST(LoweringPlane, IsTheHighestBelowAllGaps) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        Random random(seed, Purpose::test);
        std::vector<Gap> gaps(60);
        for (Gap& gap : gaps)
            gap = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0, 0.3)};
        const LoweringPlane plane = lowering_plane(gaps, 1, 0.5);
        for (const Gap& gap : gaps)
            EXPECT_GE(gap.height,
                      plane.height + plane.slope_x * gap.x + plane.slope_z * gap.z - 1e-8);
        // Any other plane below the gaps is lower at the centre: tried on a grid of slopes.
        double best = 0;
        for (int i = -25; i <= 25; ++i)
            for (int j = -25; j <= 25; ++j) {
                const double x = 0.02 * i, z = 0.02 * j;
                double height = 10;
                for (const Gap& gap : gaps)
                    height = std::min(height, gap.height - x * gap.x - z * gap.z);
                best = std::max(best, height);
            }
        EXPECT_GE(plane.height, best - 1e-9);
        EXPECT_LE(plane.held ? plane.height : 0, best + 0.04);
    }
}

TEST(ExactContact, MovesARockDownToWhereItTouches) {
    // Onto one other rock, against brute force over dense points of both surfaces.
    const std::vector<RockSurface> surfaces{rock(1), rock(2)};
    const Ground ground(0);
    Random random(5, Purpose::test);
    for (int trial = 0; trial < 20; ++trial) {
        HeightMap map(Box2(Vec2(-2), Vec2(2)), 1.0 / 24, ground);
        std::vector<PlacedRock> rocks(1);
        rocks[0] = {.surface = 0,
                    .scale = 0.6,
                    .centre = {},
                    .world_from_rock = random_turn(random),
                    .placed = true};
        const Vec2 middle = map.place(48, 48);
        rocks[0].centre = {middle.x, 0.8, middle.y};
        std::vector<Vec3> below;
        pose_vertices(surfaces[0], rocks[0].world_from_rock, 0.6, below);
        map.add(rocks[0], surfaces[0], 0);

        const std::vector<std::shared_ptr<const TopGrid>> tops(1);
        const Neighbourhood around{map, ground, surfaces, rocks, tops};
        std::vector<Vec3> above;
        pose_vertices(surfaces[1], random_turn(random), 0.5, above);
        Footprint under;
        rasterise(above, surfaces[1].triangles, map.cell(), Side::under, under);
        const double height = map.rest(under, 52, 46, 0);
        const Vec2 centre = map.place(52, 46);
        Surroundings surroundings;
        surroundings.gather(around, {centre.x, height, centre.y}, 0.6, 0);
        ExactContact contact;
        double least = 1;
        for (const Gap& gap : contact.gaps({.vertices = above,
                              .triangles = surfaces[1].triangles,
                              .centre = {centre.x, height, centre.y}},
                                           surroundings, ground, 0.5))
            least = std::min(least, gap.height);
        ASSERT_LT(least, 0.5);
        EXPECT_GE(least, -1e-5);

        // The least vertical distance over a fine grid of lines.
        const auto at = [](const std::vector<Vec3>& p, const std::vector<Mesh::Triangle>& triangles,
                           const Vec2& place, bool upper) {
            double best = upper ? -1e9 : 1e9;
            for (const Mesh::Triangle& t : triangles) {
                const Vec2 a(p[t[0]].x, p[t[0]].z), b(p[t[1]].x, p[t[1]].z),
                    c(p[t[2]].x, p[t[2]].z);
                const double area = cross(b - a, c - a);
                if (area == 0)
                    continue;
                const double u = cross(place - a, c - a) / area;
                const double v = cross(b - a, place - a) / area;
                if (u < 0 || v < 0 || u + v > 1)
                    continue;
                const double y = double(p[t[0]].y) + u * double(p[t[1]].y - p[t[0]].y) +
                                 v * double(p[t[2]].y - p[t[0]].y);
                best = upper ? std::max(best, y) : std::min(best, y);
            }
            return best;
        };
        double brute = 1e9;
        for (int i = -60; i <= 60; ++i)
            for (int j = -60; j <= 60; ++j) {
                const double x = 0.01 * i, z = 0.01 * j;
                const double bottom = height + at(above, surfaces[1].triangles, {x, z}, false);
                const Vec2 seen = centre + Vec2(x, z) - middle;
                const double rock_top = 0.8 + at(below, surfaces[0].triangles, seen, true);
                brute = std::min(brute, bottom - std::max(rock_top, 0.0));
            }
        EXPECT_LE(least, brute + 1e-5);
        EXPECT_GE(least, brute - 0.02); // a line may miss the touching corner by half a step
    }
}

TEST(RockSizes, FollowTheirDistributions) {
    // Kolmogorov-Smirnov against the closed forms.
    const auto distance = [](std::vector<double> sizes, const auto& longer_share) {
        std::sort(sizes.begin(), sizes.end());
        double most = 0;
        for (std::size_t i = 0; i < sizes.size(); ++i)
            most = std::max(most, std::abs(1 - longer_share(sizes[i]) -
                                           (double(i) + 0.5) / double(sizes.size())));
        return most;
    };
    for (const double q : {0.5, 2.0, 2.5, 4.0}) {
        const std::vector<double> sizes = power_sizes(0.05, 1.5, q, 2500, 3);
        EXPECT_TRUE(std::is_sorted(sizes.rbegin(), sizes.rend()));
        const double low = std::pow(0.05, -q);
        const double high = std::pow(1.5, -q);
        EXPECT_LT(
            distance(sizes, [&](double d) { return (std::pow(d, -q) - high) / (low - high); }),
            0.02);
        double squares = 0;
        for (const double d : sizes)
            squares += d * d / double(sizes.size());
        EXPECT_NEAR(squares, power_mean_square(0.05, 1.5, q), 0.03 * squares);
    }
    // Golombek & Rapp: rocks longer than D cover exp(-q D) of what all cover.
    const double k = 0.2;
    const double q = 1.79 + 0.152 / k;
    const std::vector<double> sizes = area_sizes(k, 0.05, 2, 4000, 0.55, 1);
    for (const double d : {0.05, 0.2, 0.5, 1.0}) {
        double covered = 0;
        for (const double size : sizes)
            covered += size >= d ? 0.55 * size * size / 4000 : 0;
        EXPECT_NEAR(covered, k * (std::exp(-q * d) - std::exp(-q * 2)), 0.01 * k) << d;
    }
}

// Dropped rocks: what they rest on holds them, whatever the number of threads.
class Drop : public testing::Test {
  protected:
    std::vector<PlacedRock> drop(int threads) {
        const ThreadLimit limit(threads);
        return drop_rocks({.ground = ground,
                           .domain = domain,
                           .surfaces = surfaces,
                           .sizes = power_sizes(0.1, 0.6, 2, 500, 1),
                           .surface_of =
                               [&](std::size_t, std::uint32_t kind) {
                                   return kind % std::uint32_t(surfaces.size());
                               },
                           .likely = {},
                           .rest = {.burial = 0},
                           .seed = 4},
                          {});
    }

    Ground ground{0.3};
    Region domain = square(4);
    std::vector<RockSurface> surfaces{rock(1), rock(2), rock(3), rock(4), rock(5), rock(6)};
};

TEST_F(Drop, DoesNotDependOnThreads) {
    const std::vector<PlacedRock> one = drop(1);
    const std::vector<PlacedRock> two = drop(2);
    ASSERT_EQ(one.size(), two.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
        EXPECT_EQ(one[i].placed, two[i].placed);
        EXPECT_EQ(one[i].centre, two[i].centre);
        EXPECT_EQ(one[i].world_from_rock, two[i].world_from_rock);
    }
}

TEST_F(Drop, PlacesNearlyAllAndNoneUnderground) {
    const std::vector<PlacedRock> rocks = drop(0);
    std::size_t placed = 0;
    for (const PlacedRock& one : rocks) {
        if (!one.placed)
            continue;
        ++placed;
        std::vector<Vec3> vertices;
        pose_vertices(surfaces[one.surface], one.world_from_rock, one.scale, vertices);
        for (const Vec3& v : vertices) {
            const WideVec3 p = one.centre + WideVec3(v);
            EXPECT_GT(p.y - ground.height({p.x, p.z}), -1e-5);
        }
    }
    EXPECT_GT(placed, rocks.size() * 9 / 10);
}

} // namespace scree::rocks
