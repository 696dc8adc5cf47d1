// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/bodies/push.h"
#include "tests/support/piles.h"

#include <gtest/gtest.h>

namespace scree {
namespace {

using tests::component_mesh;
using tests::fact;

Mesh rice() { return component_mesh("rice", {}); }
Mesh ball(double radius) { return component_mesh("sphere", {{"radius", radius}}); }

Params relaxed(const Mesh& target, const char* fill) {
    Params params = tests::pile_params(target, {tests::pile_component(rice())});
    params.set("method", std::string("relax"));
    params.set("fill", std::string(fill));
    params.set("rotation", Vec3(2 * pi_f));
    return params;
}

TEST(PileRelax, MassOfABoxByClosedForm) {
    const Body box = *tests::body_of(component_mesh(
        "box", {{"width", 0.002}, {"height", 0.004}, {"depth", 0.006}, {"rounding", 0.0}}));
    const MassProperties mass = mass_properties(box);
    const double m = 0.002 * 0.004 * 0.006;
    EXPECT_NEAR(mass.mass, m, 1e-5 * m);
    const Vec3 middle = bounds(*box.mesh).center() - box.origin;
    EXPECT_NEAR(double((mass.centre - middle).length()), 0, 1e-7);
    const std::array<double, 3> squares{0.002 * 0.002, 0.004 * 0.004, 0.006 * 0.006};
    for (int i = 0; i < 3; ++i) {
        const double inertia =
            m / 12 * (squares[std::size_t((i + 1) % 3)] + squares[std::size_t((i + 2) % 3)]);
        EXPECT_NEAR(mass.inverse_inertia[i][i] * inertia, 1, 1e-3);
    }
}

TEST(PileRelax, TwoBallsPartSymmetrically) {
    const Body sphere = *tests::body_of(ball(0.01));
    const MassProperties mass = mass_properties(sphere);
    MovingBody a{&sphere, &mass, {}};
    MovingBody b{&sphere, &mass, {}};
    a.pose.centre = {-0.008, 0.003, 0};
    b.pose.centre = {0.008, 0.003, 0};
    EXPECT_NEAR(push_apart(a, b, 0), 0.004, 0.0002);
    EXPECT_NEAR((b.pose.centre - a.pose.centre).length(), 0.02, 0.0003);
    const Imath::V3d middle = (a.pose.centre + b.pose.centre) / 2;
    EXPECT_NEAR((middle - Imath::V3d(0, 0.003, 0)).length(), 0, 1e-6);
    EXPECT_NEAR(a.pose.centre.y, 0.003, 0.0005);
}

TEST(PileRelax, APushBesideTheCentreTurns) {
    const Body box = *tests::body_of(component_mesh(
        "box", {{"width", 0.04}, {"height", 0.01}, {"depth", 0.01}, {"rounding", 0.0}}));
    const Body sphere = *tests::body_of(ball(0.005));
    const MassProperties box_mass = mass_properties(box);
    const MassProperties ball_mass = mass_properties(sphere);
    MovingBody a{&box, &box_mass, {}};
    MovingBody b{&sphere, &ball_mass, {}};
    b.pose.centre = {0.018, 0.009, 0}; // over the end, one millimetre in
    EXPECT_GT(push_apart(a, b, 0), 0.0005);
    EXPECT_LT(a.pose.world_from_body[0][1], -0.001F); // the end goes down
    EXPECT_LT(a.pose.centre.y, 0);
    EXPECT_GT(b.pose.centre.y, 0.009);
    const Imath::M33f m = a.pose.world_from_body;
    EXPECT_NEAR(double(m.determinant()), 1, 1e-5);
}

TEST(PileRelax, NoGrainIsDeepInAnother) {
    const Mesh mesh = rice();
    const Aggregate pile = pile_plugin().make(relaxed(ball(0.006), "solid"))({});
    ASSERT_GT(pile.instances.size(), 10U);
    EXPECT_LE(tests::deepest_vertex(pile, mesh), 0.02 * tests::body_of(mesh)->radius);
}

TEST(PileRelax, LeavesLittleOverlap) {
    for (const char* fill : {"surface", "solid"}) {
        const Aggregate pile = pile_plugin().make(relaxed(ball(0.015), fill))({});
        EXPECT_GT(pile.instances.size(), 200U);
        EXPECT_GT(fact(pile, "start_depth_mean"), 0.3); // as strewn
        EXPECT_LE(fact(pile, "depth_max"), 0.02);
        EXPECT_LT(fact(pile, "volume_overlap"), 0.003);
    }
}

TEST(PileRelax, SkinStaysWithinItsRange) {
    constexpr double radius = 0.012;
    const Imath::V3d centre(0, radius, 0); // it stands on y = 0
    const Aggregate pile = pile_plugin().make(relaxed(ball(radius), "surface"))({});
    const PileKind kind = tests::kind_of(rice(), 3, 2);
    ASSERT_GT(pile.instances.size(), 20U);
    for (const Instance& instance : pile.instances) {
        const double height =
            (Imath::V3d(kind.body->origin) * Imath::M44d(instance.world_from_object) - centre)
                .length() -
            radius;
        EXPECT_GE(height, -0.1 * kind.body->radius);
        EXPECT_LE(height, kind.range() + 0.1 * kind.body->radius);
    }
    EXPECT_LE(fact(pile, "depth_max"), 0.02);
}

TEST(PileRelax, SameBytesOnAnyNumberOfThreads) {
    for (const char* fill : {"surface", "solid"}) {
        SCOPED_TRACE(fill);
        tests::expect_same_on_any_threads(
            [&] { return pile_plugin().make(relaxed(ball(0.008), fill))({}); });
    }
}

} // namespace
} // namespace scree
