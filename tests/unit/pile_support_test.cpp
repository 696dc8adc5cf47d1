// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/parallel.h"
#include "core/random.h"
#include "geometry/bodies/mass_properties.h"
#include "geometry/bodies/support.h"
#include "geometry/bodies/target_contact.h"
#include "geometry/plane/convex_hull.h"
#include "tests/support/piles.h"

#include <gtest/gtest.h>

#include <set>

namespace scree {
namespace {

using tests::component_mesh;
using Vec3d = Imath::V3d;

constexpr double half = 0.005; // half the side of the cubes and the radius of the balls [m]

Mesh cube() {
    return component_mesh(
        "box", {{"width", 2 * half}, {"height", 2 * half}, {"depth", 2 * half}, {"rounding", 0.0}});
}
Mesh ball() { return component_mesh("sphere", {{"radius", half}}); }

Bodies bodies_of(std::vector<Mesh> meshes) {
    Bodies bodies;
    for (Mesh& mesh : meshes)
        bodies.push_back(tests::body_of(std::move(mesh)));
    return bodies;
}

/// Copies of the first body, upright.
PlacedBodies pile_at(const Bodies& bodies, const std::vector<Vec3d>& centres) {
    PlacedBodies pile(bodies);
    for (const Vec3d& centre : centres)
        pile.add({.body = 0, .pose = {centre, {}}});
    return pile;
}

Support support_on_floor(const PlacedBodies& pile) {
    return support_of(contact_graph(pile, {.floor = 0.0}));
}

std::vector<int> indices(const std::vector<char>& flags) {
    std::vector<int> out;
    for (std::size_t i = 0; i < flags.size(); ++i)
        if (flags[i])
            out.push_back(int(i));
    return out;
}

using Indices = std::vector<int>;

TEST(PileSupport, ThreeStackedBoxesStand) {
    const Bodies bodies = bodies_of({cube()});
    const PlacedBodies pile = pile_at(bodies, {{0, half, 0}, {0, 3 * half, 0}, {0, 5 * half, 0}});
    const ContactGraph graph = contact_graph(pile, {.floor = 0.0});
    EXPECT_EQ(indices(support_of(graph).falling), Indices{});
    EXPECT_EQ(contact_groups(graph), 1U);
    EXPECT_NEAR(mean_contacts(graph), 4.0 / 3, 1e-12);
}

TEST(PileSupport, OverhangByMoreThanHalfFalls) {
    const Bodies bodies = bodies_of({cube()});
    for (const double share : {-0.55, -0.4, 0.4, 0.47, 0.53, 0.8}) {
        const PlacedBodies pile = pile_at(
            bodies,
            {{0, half, 0}, {2 * share * half, 3 * half, 0}, {2 * share * half, 5 * half, 0}});
        const Support support = support_on_floor(pile);
        const bool falls = std::abs(share) > 0.5;
        EXPECT_EQ(indices(support.unsupported), falls ? Indices{1} : Indices{}) << share;
        EXPECT_EQ(indices(support.falling), falls ? (Indices{1, 2}) : Indices{}) << share;
    }
}

TEST(PileSupport, BridgeStandsUntilItsPierGoes) {
    const Bodies bodies = bodies_of({cube()});
    const double apart = 1.4 * half;
    const Vec3d left(-apart, half, 0);
    const Vec3d right(apart, half, 0);
    const Vec3d deck(0, 3 * half, 0);
    EXPECT_EQ(indices(support_on_floor(pile_at(bodies, {left, right, deck})).falling), Indices{});
    EXPECT_EQ(indices(support_on_floor(pile_at(bodies, {left, deck})).falling), Indices{1});
}

TEST(PileSupport, FloatingBallIsFound) {
    const Bodies bodies = bodies_of({ball()});
    const Support support =
        support_on_floor(pile_at(bodies, {{0, half, 0}, {0, 3.2 * half, 0}, {0.1, half, 0}}));
    EXPECT_EQ(indices(support.floating), Indices{1});
    EXPECT_EQ(indices(support.unsupported), Indices{});
    EXPECT_EQ(indices(support.falling), Indices{1});
}

TEST(PileSupport, WhatHangsOrClingsToASideFalls) {
    const Bodies bodies = bodies_of({cube()});
    const PlacedBodies pile =
        pile_at(bodies, {{0, half, 0}, {0, 3 * half, 0}, {2 * half, 3.5 * half, 0}});
    const Support support = support_on_floor(pile);
    EXPECT_EQ(indices(support.floating), Indices{});
    EXPECT_EQ(indices(support.unsupported), Indices{2});
}

// Cards flat on each other: one stays as long as its middle is above the one below.
TEST(PileSupport, CardsThatOverhangByMoreThanHalfFall) {
    constexpr double side = 0.02;
    constexpr double thickness = 0.0005;
    const Bodies bodies{tests::body_of(component_mesh("plane", {{"size", side}}), thickness)};
    for (const double share : {-0.6, -0.4, 0.0, 0.4, 0.6}) {
        const PlacedBodies pile = pile_at(bodies, {{0, 0.5 * thickness, 0},
                                                   {share * side, 1.5 * thickness, 0},
                                                   {share * side, 2.5 * thickness, 0},
                                                   {0, 6 * thickness, 0}});
        const Support support = support_on_floor(pile);
        const bool falls = std::abs(share) > 0.5;
        EXPECT_EQ(indices(support.floating), Indices{3}) << share;
        EXPECT_EQ(indices(support.unsupported), falls ? Indices{1} : Indices{}) << share;
        EXPECT_EQ(indices(support.falling), falls ? (Indices{1, 2, 3}) : Indices{3}) << share;
    }
}

TEST(PileSupport, WhatSticksToTheTargetStays) {
    const Bodies bodies = bodies_of({ball()});
    const Mesh target = component_mesh("sphere", {{"radius", 0.02}}); // stands on y = 0
    const double under = -half;
    const PlacedBodies pile = pile_at(bodies, {{0, under, 0},
                                               {0, under - 2 * half, 0},
                                               {0, 0.04 + half, 0},
                                               {0, 0.04 + 3 * half, 0},
                                               {0.1, 0, 0}});
    const Support support = support_of(contact_graph(pile, {.adhesive = &target}));
    EXPECT_EQ(indices(support.floating), Indices{4});
    EXPECT_EQ(indices(support.unsupported), Indices{1});
    EXPECT_EQ(indices(support.falling), (Indices{1, 4}));
}

TEST(PileSupport, GroupsOfScatteredBalls) {
    const Bodies bodies = bodies_of({ball()});
    const PlacedBodies pile =
        pile_at(bodies, {{0, 0, 0}, {2 * half, 0, 0}, {0.1, 0, 0}, {0.2, 0, 0}});
    EXPECT_EQ(contact_groups(contact_graph(pile, {})), 3U);
}

TEST(PileSupport, LowestPointOfTurnedCubes) {
    const Bodies bodies = bodies_of({cube()});
    PlacedBodies pile(bodies);
    PlacedBody placed;
    placed.pose.world_from_body = Imath::M33f(std::sqrt(0.5F), std::sqrt(0.5F), 0, -std::sqrt(0.5F),
                                              std::sqrt(0.5F), 0, 0, 0, 1);
    pile.add(placed);
    EXPECT_NEAR(lowest_point(pile), -half * std::sqrt(2), 0.01 * half);
}

Vec3d mass_centre(const Mesh& mesh, double thickness) {
    const BodyDraft draft = draft_body(std::make_shared<const Mesh>(mesh), thickness);
    return Vec3d(draft.body->origin + mass_properties(*draft.body).centre);
}

TEST(PileSupport, MassCentreOfAConeAndOfTwoSquares) {
    const Vec3d cone = mass_centre(
        component_mesh("cone", {{"radius", 0.01}, {"height", 0.03}, {"rounding", 0.0}}), 0);
    EXPECT_NEAR(cone.y, 0.03 / 4, 2e-4);
    Mesh corner; // two squares of side 1 that meet along z: the mean of (0.5, 0) and (0, 0.5)
    corner.positions = {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}, {0, 1, 0}, {0, 1, 1}};
    corner.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 5}, {0, 5, 4}};
    const Vec3d centre = mass_centre(corner, 0.01);
    EXPECT_NEAR((centre - Vec3d(0.25, 0.25, 0.5)).length(), 0, 1e-6);
}

TEST(PileSupport, ConvexHullAgainstEveryHalfPlane) {
    for (std::uint64_t i = 0; i < 300; ++i) {
        Random random(4, Purpose::test, i);
        std::vector<Vec2> points(1 + random.below(9));
        for (Vec2& p : points)
            p = {random.below(7) - 3.0, random.below(7) - 3.0}; // many of them collinear or equal
        // The origin is outside of the hull if all points lie ahead of it in some direction.
        bool outside = false;
        for (int k = 0; k < 3600 && !outside; ++k) {
            const Vec2 d = rotate({1.0, 0.0}, 2 * pi * (k + 0.37) / 3600);
            outside = true;
            for (const Vec2& p : points)
                outside = outside && p.dot(d) > 0;
        }
        EXPECT_EQ(in_convex_hull(Vec2(0.0), points, 1e-12), !outside) << i;
    }
}

/// A pile of cones and boxes, many of which nothing holds up.
PlacedBodies mixed_pile(const Bodies& bodies, double size) {
    PlacedBodies pile(bodies);
    for (std::uint64_t i = 0; i < 60; ++i) {
        Random random(8, Purpose::test, i);
        PlacedBody placed;
        placed.body = static_cast<std::uint32_t>(i % 2);
        for (int axis = 0; axis < 3; ++axis)
            placed.pose.centre[axis] = random.uniform(-size, size);
        const Vec3 turn(static_cast<float>(random.uniform(0, 6)),
                        static_cast<float>(random.uniform(0, 6)), 0);
        const Matrix m = Matrix().setEulerAngles(turn);
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 3; ++column)
                placed.pose.world_from_body[row][column] = m[row][column];
        pile.add(placed);
    }
    return pile;
}

Bodies small_bodies() {
    return bodies_of(
        {component_mesh("cone", {{"radius", 0.0015},
                                 {"height", 0.004},
                                 {"rounding", 0.0},
                                 {"segments", std::int64_t{12}}}),
         component_mesh(
             "box", {{"width", 0.003}, {"height", 0.002}, {"depth", 0.002}, {"rounding", 0.0}})});
}

// The gap between two placed meshes, negative if they overlap: the least exact distance to one of
// dense points of the other.
double gap_between(const PlacedBodies& pile, const PlacedBody& a, const PlacedBody& b) {
    double gap = 1;
    for (const auto& [from, to] : {std::pair(&a, &b), std::pair(&b, &a)}) {
        const Body& own = pile.body(*from);
        const Body& other = pile.body(*to);
        const RelativePose there = relative(from->pose, to->pose);
        for (const Ball& sample : own.samples.balls())
            gap = std::min(gap, tests::signed_distance(*other.mesh,
                                                       Vec3d(there(sample.centre) + other.origin)));
    }
    return gap;
}

TEST(PileSupport, ContactsAgainstExactDistances) {
    const Bodies bodies = small_bodies();
    const PlacedBodies pile = mixed_pile(bodies, 0.006);
    PlacedBodies few(bodies);
    for (std::size_t i = 0; i < 20; ++i)
        few.add(pile.all[i]);
    constexpr double tolerance = 0.07;
    const ContactGraph graph = contact_graph(few, {.tolerance = tolerance});
    int touching = 0;
    int apart = 0;
    for (std::uint32_t i = 0; i < 20; ++i) {
        std::set<std::uint32_t> found;
        for (const Contact& contact : graph.contacts[i])
            found.insert(contact.other);
        for (std::uint32_t j = 0; j < i; ++j) {
            const PlacedBody& a = few.all[i];
            const PlacedBody& b = few.all[j];
            const double radius = std::min(few.body(a).radius, few.body(b).radius);
            if ((a.pose.centre - b.pose.centre).length() >
                few.body(a).reach + few.body(b).reach + radius) {
                EXPECT_EQ(found.count(j), 0U);
                continue;
            }
            const double gap = gap_between(few, a, b) / radius;
            if (std::abs(gap - tolerance) < 0.03)
                continue; // the grid's error
            EXPECT_EQ(found.count(j), gap < tolerance ? 1U : 0U) << gap;
            ++(gap < tolerance ? touching : apart);
        }
    }
    EXPECT_GT(touching, 5);
    EXPECT_GT(apart, 5);
}

TEST(PileSupport, TouchingTheTargetAgainstBalls) {
    const Bodies bodies = bodies_of({ball()});
    const Mesh plane = component_mesh("plane", {});
    std::vector<Vec3d> centres;
    for (int i = 0; i < 100; ++i)
        centres.push_back({0.004 * i - 0.2, half * (-2 + 0.04 * i), 0.001 * i});
    const std::vector<char> touching = touching_target(pile_at(bodies, centres), plane, 0.05);
    for (std::size_t i = 0; i < centres.size(); ++i) {
        const double gap = std::abs(centres[i].y) - half;
        if (std::abs(gap - 0.05 * half) > 0.03 * half) {
            EXPECT_EQ(touching[i] != 0, gap < 0.05 * half) << centres[i].y / half;
        }
    }
}

TEST(PileSupport, SameGraphOnAnyNumberOfThreads) {
    const Bodies bodies = small_bodies();
    const PlacedBodies pile = mixed_pile(bodies, 0.008);
    const Mesh target = component_mesh("sphere", {{"radius", 0.004}});
    std::vector<ContactGraph> graphs;
    for (const int threads : {1, 2, 5}) {
        const ThreadLimit limit(threads);
        graphs.push_back(contact_graph(pile, {.adhesive = &target, .floor = -0.004}));
    }
    for (const ContactGraph& graph : graphs) {
        EXPECT_EQ(graph.anchored, graphs[0].anchored);
        EXPECT_EQ(graph.floor, graphs[0].floor);
        for (std::size_t i = 0; i < graph.size(); ++i) {
            ASSERT_EQ(graph.contacts[i].size(), graphs[0].contacts[i].size());
            for (std::size_t k = 0; k < graph.contacts[i].size(); ++k) {
                EXPECT_EQ(graph.contacts[i][k].other, graphs[0].contacts[i][k].other);
                EXPECT_EQ(graph.contacts[i][k].supports, graphs[0].contacts[i][k].supports);
            }
        }
    }
}

TEST(PileSupport, RemovalLeavesNothingThatFalls) {
    const Bodies bodies = small_bodies();
    const PlacedBodies pile = mixed_pile(bodies, 0.008);
    const Support support = support_of(contact_graph(pile, {.floor = -0.008}));
    PlacedBodies left(bodies);
    for (std::size_t i = 0; i < pile.all.size(); ++i)
        if (!support.falling[i])
            left.add(pile.all[i]);
    ASSERT_GT(left.all.size(), 3U);
    ASSERT_LT(left.all.size(), pile.all.size());
    EXPECT_EQ(indices(support_of(contact_graph(left, {.floor = -0.008})).falling), Indices{});
}

TEST(PileSupport, ReportedAndRemovedByTheGenerator) {
    Params params = tests::pile_params(component_mesh("sphere", {{"radius", 0.01}}),
                                       {tests::pile_component(component_mesh("rice", {}))});
    params.set("cover", 0.8);
    params.set("rotation", Vec3(2 * pi_f));
    params.set("contact", 0.05);
    params.set("support", std::string("report"));
    const Aggregate all = pile_plugin().make(params)({});
    ASSERT_GT(tests::fact(all, "falling"), 0);
    params.set("support", std::string("remove"));
    const Aggregate left = pile_plugin().make(params)({});
    EXPECT_EQ(tests::fact(left, "count"), tests::fact(all, "count") - tests::fact(all, "falling"));
    // With a floor far below, all components float.
    params.set("adhesive", false);
    params.set("floor", -1.0);
    EXPECT_EQ(pile_plugin().make(params)({}).instances.size(), 0U);
}

} // namespace
} // namespace scree
