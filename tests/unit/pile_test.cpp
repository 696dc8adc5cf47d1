// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/error.h"
#include "core/random.h"
#include "generators/pile/cover_target.h"
#include "geometry/bodies/overlap_measure.h"
#include "geometry/mesh/mesh_rays.h"
#include "tests/support/piles.h"

#include <gtest/gtest.h>

namespace scree {
namespace {

using tests::component_mesh;
using tests::fact;
using tests::kind_of;

Mesh rice() { return component_mesh("rice", {}); }
Mesh cube() {
    return component_mesh(
        "box", {{"width", 0.004}, {"height", 0.004}, {"depth", 0.004}, {"rounding", 0.0}});
}
Mesh ball(double radius) { return component_mesh("sphere", {{"radius", radius}}); }

Aggregate bake(Params params) { return pile_plugin().make(params)({}); }

Params turned_at_random(Params params) {
    params.set("rotation", Vec3(2 * pi_f));
    return params;
}

Imath::V3d to_object(const Instance& instance, const Imath::V3d& p) {
    return p * Imath::M44d(instance.world_from_object).inverse();
}

TEST(Pile, NoCubeIsDeepInAnother) {
    const Aggregate pile =
        bake(turned_at_random(tests::pile_params(ball(0.02), {tests::pile_component(cube())})));
    ASSERT_GT(pile.instances.size(), 60U);
    constexpr double half = 0.002; // which is the largest inner ball's radius
    double deepest = 0;
    for (const Instance& a : pile.instances)
        for (const Instance& b : pile.instances) {
            if (&a == &b)
                continue;
            for (int face = 0; face < 6; ++face)
                for (int i = 0; i <= 40; ++i)
                    for (int j = 0; j <= 40; ++j) {
                        Imath::V3d p;
                        p[face / 2] = face % 2 == 0 ? -half : half;
                        p[(face / 2 + 1) % 3] = half * (i / 20.0 - 1);
                        p[(face / 2 + 2) % 3] = half * (j / 20.0 - 1);
                        p.y += half; // meshes stand on y = 0
                        Imath::V3d q = to_object(b, p * Imath::M44d(a.world_from_object));
                        q.y -= half;
                        deepest = std::max(deepest, half - std::max({std::abs(q.x), std::abs(q.y),
                                                                     std::abs(q.z)}));
                    }
        }
    EXPECT_LE(deepest, 0.02 * half);
    EXPECT_GT(deepest, 0.001 * half); // they touch
}

TEST(Pile, NoGrainIsDeepInAnother) {
    const Mesh mesh = rice();
    Params params = tests::pile_params(ball(0.006), {tests::pile_component(mesh)});
    const Aggregate pile = bake(turned_at_random(std::move(params)));
    ASSERT_GT(pile.instances.size(), 15U);
    EXPECT_LE(tests::deepest_vertex(pile, mesh), 0.02 * tests::body_of(mesh)->radius);
}

TEST(Pile, EachTouchesTheTargetOrAnother) {
    const std::vector<PileKind> kinds{kind_of(rice(), 3, 4)};
    const Mesh target = ball(0.02);
    PlacedBodies pile(bodies_of(kinds));
    const PileTurns turns{.kinds = kinds, .frame = PileFrame::surface, .seed = 3};
    pile_up(pile, target, turns, pile_sites(target, turns, {}), {}, 0.8, {});
    const Body& grain = *kinds[0].body;
    int high = 0;
    for (std::size_t i = 0; i < pile.all.size(); ++i) {
        if (pile.all[i].height == 0)
            continue;
        ++high;
        EXPECT_GT(tests::greatest_depth(pile, i), -0.03 * grain.radius);
    }
    EXPECT_GT(high, 20);
}

TEST(Pile, SameBytesOnAnyNumberOfThreads) {
    for (const char* method : {"insertion", "thesis"}) {
        SCOPED_TRACE(method);
        tests::expect_same_on_any_threads([&] {
            Params params = tests::pile_params(
                ball(0.008), {tests::pile_component(rice()), tests::pile_component(cube())});
            params.set("method", std::string(method));
            params.set("spacing", 2.5);
            if (method == std::string("insertion"))
                params.set("cover", 0.8);
            return bake(std::move(params));
        });
    }
}

TEST(Pile, OverlapIsAllowedUpToT) {
    Params params =
        turned_at_random(tests::pile_params(ball(0.02), {tests::pile_component(rice())}));
    const Aggregate none = bake(params);
    params.set("overlap", 0.3);
    const Aggregate some = bake(params);
    EXPECT_LE(fact(none, "depth_max"), 0.02);
    EXPECT_GT(fact(some, "depth_max"), 0.25);
    EXPECT_LE(fact(some, "depth_max"), 0.32);
}

TEST(Pile, GlobalFrameKeepsTheComponentsUpright) {
    Params params = tests::pile_params(ball(0.02), {tests::pile_component(cube())});
    params.set("frame", std::string("global"));
    for (const Instance& instance : bake(std::move(params)).instances)
        EXPECT_NEAR(double(transform_direction(instance.world_from_object, {0, 1, 0}).y), 1, 1e-5);
}

TEST(Pile, WeightsDecideHowManyOfEach) {
    Params rare = tests::pile_component(cube());
    rare.set("weight", 0.1);
    Params params =
        tests::pile_params(ball(0.04), {tests::pile_component(cube()), std::move(rare)});
    params.set("refine", 0.1); // one layer
    const Aggregate pile = bake(std::move(params));
    EXPECT_GT(fact(pile, "count_1"), 3 * fact(pile, "count_2"));
    EXPECT_GT(fact(pile, "count_2"), 0);
}

TEST(Pile, MeasureSeesCoincidentComponents) {
    const std::vector<PileKind> kinds{kind_of(rice(), 3, 4)};
    PlacedBodies pile(bodies_of(kinds));
    pile.add({});
    pile.add({});
    const OverlapMeasure measure = measure_overlap(pile, 10, 400);
    // Interpolation cuts off the medial axis, within one step of the grid: 0.08 radii.
    EXPECT_NEAR(measure.largest_depth, 1, 0.08);
    EXPECT_NEAR(measure.volume_share, 1, 0.02);
}

TEST(Pile, MeasureOfTwoCubes) {
    const std::vector<PileKind> kinds{kind_of(cube(), 3, 4)};
    PlacedBodies pile(bodies_of(kinds));
    pile.add({});
    PlacedBody moved;
    moved.pose.centre = {0.003, 0, 0}; // a quarter of the volume, half a radius deep
    pile.add(moved);
    const OverlapMeasure measure = measure_overlap(pile, 10, 4000);
    EXPECT_NEAR(measure.largest_depth, 0.5, 0.02);
    EXPECT_NEAR(measure.volume_share, 0.25, 0.02);
}

TEST(Pile, RaysAgainstEveryTriangle) {
    const Mesh mesh = component_mesh("torus", {});
    const MeshRays rays(mesh);
    const double size = double(bounds(mesh).size().length());
    int hits = 0;
    for (int i = 0; i < 1000; ++i) {
        Random random(6, Purpose::test, std::uint64_t(i));
        Imath::V3d origin;
        Imath::V3d direction;
        for (int axis = 0; axis < 3; ++axis) {
            origin[axis] = random.uniform(-size, size);
            direction[axis] = random.uniform(-1, 1);
        }
        const Vec3 d = Vec3(direction).normalized();
        bool hit = false;
        for (const Mesh::Triangle& t : mesh.triangles) {
            // The ray passes all edges on the same side (Pluecker) and leads towards the plane.
            std::array<Imath::V3d, 3> v;
            for (std::size_t k = 0; k < 3; ++k)
                v[k] = Imath::V3d(mesh.positions[t[k]]) - origin;
            std::array<double, 3> side{};
            for (std::size_t k = 0; k < 3; ++k)
                side[k] = v[k].cross(v[(k + 1) % 3]).dot(Imath::V3d(d));
            const bool all_left = side[0] >= 0 && side[1] >= 0 && side[2] >= 0;
            const bool all_right = side[0] <= 0 && side[1] <= 0 && side[2] <= 0;
            const Imath::V3d normal = (v[1] - v[0]).cross(v[2] - v[0]);
            hit = hit ||
                  ((all_left || all_right) && v[0].dot(normal) / Imath::V3d(d).dot(normal) > 0);
        }
        EXPECT_EQ(rays.hits(origin, d, 0), hit);
        hits += hit;
    }
    EXPECT_GT(hits, 20);
}

TEST(Pile, CoverAgainstTheTrianglesThemselves) {
    const std::vector<PileKind> kinds{kind_of(rice(), 3, 4)};
    const Mesh target = ball(0.015);
    PlacedBodies pile(bodies_of(kinds));
    const PileTurns turns{.kinds = kinds, .frame = PileFrame::surface, .seed = 5};
    pile_up(pile, target, turns, pile_sites(target, turns, {}), {}, 0, {});
    Mesh all;
    for (const PlacedBody& placed : pile.all) {
        Mesh one = *kinds[0].body->mesh;
        one.uvs.clear();
        transform(one, world_from_object(placed.pose, kinds[0].body->origin));
        append(all, one);
    }
    const MeshRays truth(all);
    const std::vector<OutsideRay> rays = outside_rays(target, 4000, 9, 0);
    EXPECT_NEAR(double(rays.size()), 4000, 40); // a convex target does not hide itself
    std::size_t open = 0;
    for (const OutsideRay& ray : rays)
        open += !truth.hits(ray.origin, ray.direction, 0);
    EXPECT_GT(open, rays.size() / 50);
    EXPECT_NEAR(double(open_rays(pile, rays).size()), double(open), 0.005 * double(rays.size()));
}

TEST(Pile, CoverGrowsUntilItIsReached) {
    Params params = tests::pile_params(ball(0.015), {tests::pile_component(rice())});
    const Aggregate bare = bake(params);
    params.set("cover", 0.8);
    const Aggregate covered = bake(params);
    EXPECT_GT(fact(covered, "cover"), 0.78);
    EXPECT_LT(fact(bare, "cover"), fact(covered, "cover"));
}

TEST(Pile, SwallowedOriginIsHidden) {
    const std::vector<PileKind> kinds{kind_of(ball(0.01), 3, 4)};
    PlacedBodies pile(bodies_of(kinds));
    pile.add({});
    const OutsideRay within{{0, 0.005, 0}, {0, 1, 0}, {0, 1, 0}};
    const OutsideRay beside{{0.02, 0, 0}, {1, 0, 0}, {1, 0, 0}};
    const OutsideRay below{{0, -0.02, 0}, {0, 1, 0}, {0, 1, 0}};
    EXPECT_EQ(open_rays(pile, {within, beside, below}).size(), 1U);
}

} // namespace
} // namespace scree
