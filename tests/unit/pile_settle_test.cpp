// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "generators/pile/cover_target.h"
#include "tests/support/piles.h"

#include <gtest/gtest.h>

namespace scree {
namespace {

using tests::component_mesh;

Mesh rice() { return component_mesh("rice", {}); }
Mesh ball(double radius) { return component_mesh("sphere", {{"radius", radius}}); }
Mesh floor_of(double size) { return component_mesh("plane", {{"size", size}}); }

PileKind kind_of(const Mesh& mesh) { return tests::kind_of(mesh, 3, 2); }

PlacedBodies piled(const std::vector<PileKind>& kinds, const Mesh& target, int steps,
                   double cover) {
    PlacedBodies pile(bodies_of(kinds));
    const PileTurns turns{.kinds = kinds, .frame = PileFrame::surface, .seed = 4};
    const Settler settler(bodies_of(kinds), target, {.steps = steps});
    InsertionSettings settings;
    if (steps > 0)
        settings.settler = &settler;
    pile_up(pile, target, turns, pile_sites(target, turns, {}), settings, cover, {});
    return pile;
}

double mean_height(const PlacedBodies& pile) {
    double sum = 0;
    for (const PlacedBody& placed : pile.all)
        sum += placed.height;
    return sum / double(pile.all.size());
}

Imath::V3d to_own(const Pose& pose, const Imath::V3d& p) {
    return (p - pose.centre) * Imath::M33d(pose.world_from_body).transposed();
}

TEST(PileSettle, NoGrainIsDeepInAnother) {
    const Mesh mesh = rice();
    const std::vector<PileKind> kinds{kind_of(mesh)};
    const Body& grain = *kinds[0].body;
    const PlacedBodies pile = piled(kinds, ball(0.007), 12, 0.7);
    ASSERT_GT(pile.all.size(), 20U);
    const Box3 box = bounds(mesh);
    double deepest = 0;
    for (const PlacedBody& a : pile.all)
        for (const PlacedBody& b : pile.all) {
            if (&a == &b || (a.pose.centre - b.pose.centre).length() > 2 * grain.reach)
                continue;
            for (const Vec3& vertex : mesh.positions) {
                const Imath::V3d world =
                    a.pose.centre + Imath::V3d((vertex - grain.origin) * a.pose.world_from_body);
                const Imath::V3d p = to_own(b.pose, world) + Imath::V3d(grain.origin);
                if (box.intersects(Vec3(p)))
                    deepest = std::max(deepest, -tests::signed_distance(mesh, p));
            }
        }
    EXPECT_LE(deepest, 0.02 * grain.radius);
}

TEST(PileSettle, TurnsStayTurns) {
    const std::vector<PileKind> kinds{kind_of(rice())};
    for (const PlacedBody& placed : piled(kinds, ball(0.01), 12, 0.7).all) {
        const Imath::M33f& m = placed.pose.world_from_body;
        const Imath::M33f product = m * m.transposed();
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                EXPECT_NEAR(double(product[i][j]), i == j ? 1 : 0, 1e-5);
        EXPECT_NEAR(double(m.determinant()), 1, 1e-5);
    }
}

TEST(PileSettle, LoneBallReachesTheGround) {
    constexpr double r = 0.01;
    const std::vector<PileKind> kinds{kind_of(ball(r))};
    const Mesh floor = floor_of(0.2);
    PlacedBody start;
    start.pose.centre.y = 0.9 * r;
    const Settler settler(bodies_of(kinds), floor, {.steps = 60});
    EXPECT_NEAR(settler.settle(PlacedBodies(bodies_of(kinds)), start).pose.centre.y, 0, 0.011 * r);
    const Settler deep(bodies_of(kinds), floor, {.steps = 60, .sink = 0.05});
    EXPECT_NEAR(deep.settle(PlacedBodies(bodies_of(kinds)), start).pose.centre.y, -0.05 * r,
                0.011 * r);
}

// Three balls lie on the ground at the corners of a triangle; a fourth that touches all of them has
// its centre above the middle. It starts near one of them, away from the saddles between two, where
// the slope is too slight for it to move on.
TEST(PileSettle, BallRollsIntoThePocketOfThree) {
    constexpr double r = 0.01;
    const std::vector<PileKind> kinds{kind_of(component_mesh("sphere", {{"radius", r}}))};
    const Mesh floor = floor_of(0.2);
    const Settler settler(bodies_of(kinds), floor, {.steps = 200});
    for (const double side : {2.3 * r, 2.5 * r, 2.8 * r}) {
        const double from_middle = side / std::sqrt(3.0);
        PlacedBodies pile(bodies_of(kinds));
        for (int k = 0; k < 3; ++k) {
            PlacedBody corner;
            corner.pose.centre = {from_middle * std::cos(2 * pi * k / 3), 0,
                                  from_middle * std::sin(2 * pi * k / 3)};
            pile.add(corner);
        }
        const auto lowest_free = [&](double x, double z) {
            double height = 0;
            for (const PlacedBody& corner : pile.all) {
                const double away = std::hypot(x - corner.pose.centre.x, z - corner.pose.centre.z);
                height = std::max(height, std::sqrt(4 * r * r - away * away));
            }
            return height;
        };
        for (int k = 0; k < 12; ++k) {
            PlacedBody start;
            const int round = k / 3;
            const double angle = 2 * pi * k / 3 + 0.12 * (round - 1.5);
            const double x = 0.4 * from_middle * std::cos(angle);
            const double z = 0.4 * from_middle * std::sin(angle);
            start.pose.centre = {x, lowest_free(x, z) + 0.05 * r, z};
            const Imath::V3d end = settler.settle(pile, start).pose.centre;
            EXPECT_NEAR(end.y, lowest_free(0, 0), 0.07 * r) << side << " " << k;
            EXPECT_NEAR(std::hypot(end.x, end.z), 0, 0.2 * r) << side << " " << k;
        }
    }
}

TEST(PileSettle, ThickSkinOfRiceHidesABall) {
    std::vector<PileKind> kinds{kind_of(rice())};
    kinds[0].spacing = 1;
    kinds[0].refine = 16;
    const Mesh target = ball(0.012);
    const PlacedBodies pile = piled(kinds, target, 10, 0.995);
    const std::vector<OutsideRay> rays = outside_rays(target, 8192, 99, 5);
    EXPECT_LE(open_rays(pile, rays).size(), rays.size() / 100);
}

TEST(PileSettle, SpheresOnAPlaneRestLower) {
    std::vector<PileKind> kinds{kind_of(ball(0.01))};
    kinds[0].spacing = 1.2; // too close for neighbours to fit side by side
    kinds[0].refine = 5;
    const Mesh floor = floor_of(0.3);
    const PlacedBodies loose = piled(kinds, floor, 0, 0);
    const PlacedBodies settled = piled(kinds, floor, 20, 0);
    ASSERT_GT(settled.all.size(), 50U);
    EXPECT_LT(mean_height(settled), 0.95 * mean_height(loose));
}

TEST(PileSettle, WhatIsNotOnTheGroundTouchesOthers) {
    const std::vector<PileKind> kinds{kind_of(rice())};
    const Body& grain = *kinds[0].body;
    const PlacedBodies pile = piled(kinds, ball(0.015), 12, 0.8);
    int high = 0;
    for (std::size_t i = 0; i < pile.all.size(); ++i) {
        if (pile.all[i].height < 0.02 * grain.radius)
            continue;
        ++high;
        EXPECT_GT(tests::greatest_depth(pile, i), -0.1 * grain.radius);
    }
    EXPECT_GT(high, 20);
}

TEST(PileSettle, TurnsNoFartherThanAllowed) {
    const std::vector<PileKind> kinds{kind_of(rice())};
    const Mesh target = ball(0.01);
    const Settler none(bodies_of(kinds), target, {.steps = 12, .turn = 0});
    const Settler some(bodies_of(kinds), target, {.steps = 12, .turn = 0.2});
    const PlacedBodies below = piled(kinds, target, 0, 0);
    double most = 0;
    for (int i = 0; i < 200; ++i) {
        Random random(8, Purpose::test, std::uint64_t(i));
        PlacedBody start = below.all[std::size_t(i) % below.all.size()];
        // Above another one, farther out along the normal.
        start.pose.centre += Imath::V3d(start.normal) * (2.3 * kinds[0].body->radius);
        bool free = true;
        for (const PlacedBody& other : below.all)
            free = free && is_free(below, start, other, 0);
        if (!free)
            continue;
        const auto turn_of = [&](const PlacedBody& end) {
            const Imath::M33f d =
                end.pose.world_from_body * start.pose.world_from_body.transposed();
            return std::acos(std::clamp((double(d[0][0] + d[1][1] + d[2][2]) - 1) / 2, -1.0, 1.0));
        };
        EXPECT_LT(turn_of(none.settle(below, start)), 1e-3);
        most = std::max(most, turn_of(some.settle(below, start)));
    }
    EXPECT_LT(most, 0.201);
    EXPECT_GT(most, 0.1);
}

TEST(PileSettle, SameBytesOnAnyNumberOfThreads) {
    tests::expect_same_on_any_threads([] {
        Params params = tests::pile_params(ball(0.008), {tests::pile_component(rice())});
        params.set("cover", 0.8);
        params.set("settle", std::int64_t{12});
        return pile_plugin().make(params)({});
    });
}

} // namespace
} // namespace scree
