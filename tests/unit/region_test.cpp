// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/error.h"
#include "core/random.h"
#include "geometry/plane/region_shapes.h"
#include "geometry/plane/region_tools.h"
#include "shapes/table.h"
#include "tests/support/errors.h"
#include "tests/support/layout_params.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace scree {

namespace {

Ring moved(Ring ring, const Vec2& by) {
    for (Vec2& v : ring)
        v += by;
    return ring;
}

Ring reversed(Ring ring) {
    std::reverse(ring.begin(), ring.end());
    return ring;
}

double triangle_area(const Region& region) {
    double sum = 0;
    for (const auto& t : region.triangles) {
        const double twice = cross(region.vertices[t[1]] - region.vertices[t[0]],
                                   region.vertices[t[2]] - region.vertices[t[0]]);
        EXPECT_GT(twice, 0); // counter-clockwise
        sum += twice / 2;
    }
    return sum;
}

TEST(Triangulate, OrientsRingsAndCutsHoles) {
    // An island in a hole in a square, with every ring in the wrong orientation.
    const Region region = triangulate(
        {reversed(rectangle_ring(4, 4)), rectangle_ring(2, 2), reversed(rectangle_ring(1, 1))});
    EXPECT_NEAR(signed_area(region.rings[0]), 16, 1e-12);
    EXPECT_NEAR(signed_area(region.rings[1]), -4, 1e-12);
    EXPECT_NEAR(signed_area(region.rings[2]), 1, 1e-12);
    EXPECT_NEAR(triangle_area(region), 13, 1e-12);
    EXPECT_NEAR(area(region), 13, 1e-12);
}

TEST(Triangulate, DropsRepeatedPoints) {
    const Region region = triangulate({{{0, 0}, {0, 0}, {1, 0}, {1, 1}, {1, 1}, {0, 0}}});
    EXPECT_EQ(region.rings[0].size(), 3U);
    EXPECT_NEAR(area(region), 0.5, 1e-15);
}

TEST(Triangulate, NamesWhatIsWrong) {
    const double nan = std::nan("");
    EXPECT_EQ(tests::error_of([] { triangulate({}); }),
              "a region needs at least one ring of points");
    EXPECT_EQ(tests::error_of([&] {
                  triangulate({{{0, 0}, {1, nan}, {1, 1}}});
              }),
              "point 1 of ring 0 is not finite: (1, nan)");
    EXPECT_EQ(tests::error_of([] {
                  triangulate({{{0, 0}, {1, 0}, {0, 0}}});
              }),
              "ring 0 has 2 different points in a row, a region needs at least 3");
    EXPECT_EQ(tests::error_of([] {
                  triangulate({{{0, 0}, {2, 2}, {2, 0}, {0, 2}}});
              }),
              "edge 0 of ring 0, from (0, 0) to (2, 2) crosses or touches edge 2 of ring 0, from "
              "(2, 0) to (0, 2)");
    EXPECT_EQ(tests::error_of([] {
                  triangulate({{{0, 0}, {2, 0}, {1, 0}}});
              }),
              "edge 0 of ring 0, from (0, 0) to (2, 0) crosses or touches edge 2 of ring 0, from "
              "(1, 0) to (0, 0)");
    // Touching at a single point, exactly on an edge.
    EXPECT_EQ(tests::error_of([] {
                  triangulate({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{2, 0}, {3, 1}, {1, 1}}});
              }),
              "edge 0 of ring 0, from (0, 0) to (4, 0) crosses or touches edge 2 of ring 1, from "
              "(1, 1) to (2, 0)");
}

/// Distance to the region; 0 inside.
double outside_distance(const Region& region, const Vec2& p) {
    return std::max(0.0, signed_distance(region, p));
}

TEST(Offset, GrowsByTheMarginWithinItsBound) {
    const double margin = 0.07;
    const Region hole_shape = triangulate({rectangle_ring(1, 1), circle_ring(0.3, 24)});
    for (const Region& region :
         {triangulate({l_ring(1, 0.3)}), triangulate({star_ring(1, 0.3, 5)}), hole_shape}) {
        const Region grown = offset(region, margin);
        Random random(1, Purpose::test);
        int near = 0;
        for (int i = 0; i < 20000; ++i) {
            const Vec2 p(random.uniform(-1.3, 1.3), random.uniform(-1.3, 1.3));
            const double distance = outside_distance(region, p);
            if (distance < margin * (1 - 1e-9)) {
                EXPECT_TRUE(contains(grown, p)) << p.x << " " << p.y;
            }
            if (distance > margin * 1.0049) {
                EXPECT_FALSE(contains(grown, p)) << p.x << " " << p.y;
            }
            near += std::abs(distance - margin) < 0.02 ? 1 : 0;
        }
        EXPECT_GT(near, 100);
    }
}

TEST(Offset, ShrinksByTheMarginWithinItsBound) {
    const double margin = 0.06;
    const Region region = triangulate({l_ring(1, 0.3)});
    const Region shrunk = offset(region, -margin);
    Random random(2, Purpose::test);
    for (int i = 0; i < 20000; ++i) {
        const Vec2 p(random.uniform(-0.6, 0.6), random.uniform(-0.6, 0.6));
        const double depth = -signed_distance(region, p);
        if (depth > margin * (1 + 1e-9)) {
            EXPECT_TRUE(contains(shrunk, p)) << p.x << " " << p.y;
        }
        if (depth < margin * (1 - 0.0049)) {
            EXPECT_FALSE(contains(shrunk, p)) << p.x << " " << p.y;
        }
    }
}

TEST(Offset, GrowingClosesAHoleAndShrinkingParts) {
    const Region ring = triangulate({circle_ring(1, 40), circle_ring(0.1, 20)});
    EXPECT_EQ(offset(ring, 0.12).rings.size(), 1U);
    // Several holes at once, large and small; and the same rings as parts that vanish.
    std::vector<Ring> rings{rectangle_ring(4, 4)}, parts;
    for (int i = 0; i < 7; ++i) {
        Ring square = rectangle_ring(i % 3 == 0 ? 0.5 : 0.1, 0.5);
        for (Vec2& v : square)
            v.x += 0.5 * (i - 3);
        rings.push_back(square);
        parts.push_back(square);
    }
    EXPECT_EQ(offset(triangulate(rings), 0.08).rings.size(), 4U);
    EXPECT_EQ(offset(triangulate(parts), -0.08).rings.size(), 3U);
    // Two squares joined by a thin bridge.
    const Region dumbbell = triangulate({{{0, 0},
                                          {1, 0},
                                          {1, 0.4},
                                          {2, 0.4},
                                          {2, 0},
                                          {3, 0},
                                          {3, 1},
                                          {2, 1},
                                          {2, 0.6},
                                          {1, 0.6},
                                          {1, 1},
                                          {0, 1}}});
    EXPECT_EQ(offset(dumbbell, -0.15).rings.size(), 2U);
    EXPECT_EQ(tests::error_of([&] { offset(dumbbell, -0.6); }),
              "a margin of -0.6 m leaves nothing of the region");
}

/// A dense mesh with a known projection: a wavy annulus.
Mesh wavy_ring(int around, int across) {
    Mesh mesh;
    mesh.name = "wavy ring";
    for (int i = 0; i < around; ++i) {
        for (int j = 0; j <= across; ++j) {
            const double angle = 2 * pi * i / around;
            const double radius = 0.4 + 0.6 * j / across + 0.1 * std::sin(5 * angle);
            mesh.positions.emplace_back(float(radius * std::cos(angle)),
                                        float(0.3 * std::sin(20 * radius)),
                                        float(0.5 * radius * std::sin(angle)));
        }
    }
    const auto vertex = [&](int i, int j) {
        return std::uint32_t((i % around) * (across + 1) + j);
    };
    for (int i = 0; i < around; ++i) {
        for (int j = 0; j < across; ++j) {
            mesh.triangles.push_back({vertex(i, j), vertex(i, j + 1), vertex(i + 1, j)});
            mesh.triangles.push_back({vertex(i + 1, j), vertex(i, j + 1), vertex(i + 1, j + 1)});
        }
    }
    return mesh;
}

TEST(Silhouette, ContainsTheProjectionAndLittleMore) {
    const Mesh mesh = wavy_ring(500, 70); // 70,000 triangles
    const Region region = silhouette(mesh);
    ASSERT_EQ(region.rings.size(), 2U); // the hole stays
    EXPECT_LT(region.vertices.size(), 200U);
    Box2 box;
    for (const Vec3& p : mesh.positions) {
        const Vec2 flat(double(p.x), double(p.z));
        box.extendBy(flat);
        EXPECT_TRUE(contains(region, flat));
    }
    // The projection lies between the curves j = 0 and j = across; area by the shoelace formula.
    Ring outer, inner;
    for (int i = 0; i < 500; ++i) {
        const Vec3& o = mesh.positions[std::size_t(i) * 71 + 70];
        const Vec3& n = mesh.positions[std::size_t(i) * 71];
        outer.emplace_back(double(o.x), double(o.z));
        inner.emplace_back(double(n.x), double(n.z));
    }
    const double exact = std::abs(signed_area(outer)) - std::abs(signed_area(inner));
    EXPECT_GT(area(region), exact);
    EXPECT_LT(area(region), 1.05 * exact);
    // Documented bound: (tolerance + 1.5 / cells) of the longest side.
    const Region truth = triangulate({outer, inner});
    const double bound = (0.005 + 1.5 / 1024) * std::max(box.size().x, box.size().y);
    for (const Vec2& v : region.vertices)
        EXPECT_LE(outside_distance(truth, v), bound);
}

TEST(Silhouette, OfABoxIsItsRectangle) {
    Mesh mesh;
    mesh.name = "box";
    mesh.positions = {{-1, 0, -2}, {1, 0, -2}, {1, 0, 2}, {-1, 0, 2}};
    mesh.triangles = {{0, 2, 1}, {0, 3, 2}};
    const Region region = silhouette(mesh);
    EXPECT_EQ(region.rings.size(), 1U);
    EXPECT_EQ(region.rings[0].size(), 4U);
    EXPECT_NEAR(area(region), 8, 1e-5);
}

TEST(Silhouette, RefusesWhatHasNone) {
    Mesh mesh;
    mesh.name = "nothing";
    EXPECT_EQ(tests::error_of([&] { silhouette(mesh); }),
              "nothing has no triangles, so it has no silhouette");
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}};
    mesh.name = "wall";
    EXPECT_EQ(tests::error_of([&] { silhouette(mesh); }),
              "wall stands on edge: its projection onto the ground, 1 x 0 m, has no area");
    mesh.positions[1].x = std::numeric_limits<float>::infinity();
    EXPECT_EQ(tests::error_of([&] { silhouette(mesh); }), "vertex 1 of wall is not finite");
}

TEST(SimplifyOutward, OnlyGrowsAndOnlyByTheTolerance) {
    for (const double tolerance : {0.002, 0.02, 0.1}) {
        const Region fine = triangulate({circle_ring(1, 720), star_ring(0.7, 0.5, 60)});
        std::vector<Ring> rings = fine.rings;
        simplify_outward(rings, tolerance);
        const Region coarse = triangulate(rings); // throws if rings cross
        EXPECT_LT(coarse.vertices.size(), fine.vertices.size());
        EXPECT_GT(area(coarse), area(fine));
        Random random(3, Purpose::test);
        for (int i = 0; i < 5000; ++i) {
            const Vec2 p(random.uniform(-1.2, 1.2), random.uniform(-1.2, 1.2));
            const double distance = signed_distance(fine, p);
            if (distance < -1e-12) {
                EXPECT_TRUE(contains(coarse, p));
            }
            if (distance > tolerance + 1e-12) {
                EXPECT_FALSE(contains(coarse, p));
            }
        }
    }
}

Region make(const std::string& name, const std::vector<std::pair<std::string, Value>>& values) {
    const Registry<MakeRegion> table = region_table();
    const Plugin<MakeRegion>* plugin = table.find(name);
    Params params = tests::defaults(plugin->params, "region." + name);
    int line = 30;
    for (const auto& [key, value] : values)
        params.set(key, value, {"scene.lua", line++});
    return plugin->make(params);
}

TEST(RegionTable, MakesWhatItSays) {
    EXPECT_NEAR(area(make("rectangle", {{"width", 2.0}, {"depth", 1.5}})), 3, 1e-12);
    EXPECT_NEAR(area(make("circle", {{"radius", 2.0}})), 4 * pi, 0.05);
    EXPECT_NEAR(area(make("l", {{"size", 1.0}, {"stroke", 0.3}})), 0.51, 1e-12);
    EXPECT_NEAR(area(make("u", {{"size", 1.0}, {"stroke", 0.2}})), 0.2 + 2 * 0.8 * 0.2, 1e-12);
    EXPECT_NEAR(area(make("chevron", {{"size", 1.0}, {"stroke", 0.2}})), 0.2, 1e-12);
    EXPECT_GT(area(make("star", {})), 0);
}

TEST(RegionTable, LocatesMistakes) {
    const Ring square = rectangle_ring(2, 2);
    EXPECT_EQ(tests::error_of([&] {
                  make("polygon", {{"points", Ring{{0, 0}, {2, 2}, {2, 0}, {0, 2}}}});
              }),
              "scene.lua:30: region.polygon.points: edge 0 of ring 0, from (0, 0) to (2, 2) "
              "crosses or touches edge 2 of ring 0, from (2, 0) to (0, 2)");
    Params hole("region.polygon.holes[1]", {"scene.lua", 40});
    hole.set("points", moved(rectangle_ring(1, 1), {5, 0}), {"scene.lua", 41});
    const auto holes = std::make_shared<const std::vector<Params>>(std::vector<Params>{hole});
    EXPECT_EQ(tests::error_of([&] {
                  make("polygon", {{"points", square}, {"holes", holes}});
              }),
              "scene.lua:41: region.polygon.holes[1].points: the hole at (4.5, -0.5) lies outside "
              "the polygon");
    EXPECT_EQ(tests::error_of([&] {
                  make("u", {{"size", 1.0}, {"stroke", 0.5}});
              }),
              "scene.lua:31: region.u.stroke: 0.5 m is too wide for a size of 1 m: it must be less "
              "than 0.5 m");
}

} // namespace

} // namespace scree
