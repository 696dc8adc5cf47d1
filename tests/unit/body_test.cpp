// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/error.h"
#include "core/random.h"
#include "tests/support/piles.h"

#include <gtest/gtest.h>

namespace scree {
namespace {

using tests::body_of;
using tests::component_mesh;

Mesh rice() { return component_mesh("rice", {}); }

TEST(Body, LargestBallOfABox) {
    const Body box = *body_of(component_mesh(
        "box", {{"width", 0.06}, {"height", 0.02}, {"depth", 0.03}, {"rounding", 0.0}}));
    EXPECT_NEAR(box.radius, 0.01, 1e-5);
    EXPECT_NEAR(double(box.origin.y), 0.01, 1e-5);
    // The ball fits anywhere along the middle, half the height away from the sides.
    EXPECT_LE(std::abs(box.origin.x), 0.02F + 1e-5F);
    EXPECT_LE(std::abs(box.origin.z), 0.005F + 1e-5F);
}

TEST(Body, LargestBallOfASphere) {
    const Body sphere = *body_of(component_mesh("sphere", {{"radius", 0.5}}));
    EXPECT_NEAR(sphere.radius, 0.5, 0.5 * 0.005); // its facets
    EXPECT_NEAR(double((sphere.origin - Vec3(0, 0.5F, 0)).length()), 0, 0.5 * 0.01);
    EXPECT_NEAR(sphere.reach, 0.5, 0.5 * 0.01);
    EXPECT_DOUBLE_EQ(unit_radius_of(sphere), sphere.radius / 2);
}

TEST(Body, LargestBallOfAGrainIsNoSmallerThanAnyFoundByTrying) {
    const Body grain = *body_of(rice());
    const Mesh& mesh = *grain.mesh;
    EXPECT_NEAR(-tests::signed_distance(mesh, Imath::V3d(grain.origin)), grain.radius,
                1e-4 * grain.radius);
    const Box3 box = bounds(mesh);
    double best = 0;
    for (int i = 0; i < 400; ++i) {
        Random random(1, Purpose::test, std::uint64_t(i));
        Imath::V3d p;
        for (int axis = 0; axis < 3; ++axis)
            p[axis] = random.uniform(double(box.min[axis]), double(box.max[axis]));
        best = std::max(best, -tests::signed_distance(mesh, p));
    }
    EXPECT_GT(best, 0.9 * grain.radius);
    EXPECT_LE(best, grain.radius * 1.001);
}

TEST(Body, DistanceAgainstBruteForce) {
    for (const Mesh& mesh : {rice(), component_mesh("torus", {})}) {
        const Body body = *body_of(mesh);
        for (int i = 0; i < 300; ++i) {
            Random random(2, Purpose::test, std::uint64_t(i));
            const Box3 box = bounds(mesh);
            Imath::V3d p;
            for (int axis = 0; axis < 3; ++axis)
                p[axis] = random.uniform(double(box.min[axis]) - body.radius,
                                         double(box.max[axis]) + body.radius);
            const double truth = tests::signed_distance(mesh, p);
            const auto found = double(body.distance.at(Vec3(p) - body.origin));
            const double step = body.distance.step();
            if (truth > 0.9 * step) // perhaps outside of the grid
                EXPECT_LE(found, truth + 0.01 * body.radius);
            else if (truth > -body.radius / 2) // off the medial axis
                EXPECT_NEAR(found, truth, 0.01 * body.radius);
            else
                EXPECT_NEAR(found, truth, step);
        }
    }
}

TEST(Body, DistanceFarAwayIsABoundFromBelow) {
    const Body grain = *body_of(rice());
    for (int i = 0; i < 100; ++i) {
        Random random(3, Purpose::test, std::uint64_t(i));
        const Imath::V3d p(random.uniform(-0.02, 0.02), random.uniform(-0.02, 0.02),
                           random.uniform(-0.02, 0.02));
        const double truth = tests::signed_distance(*grain.mesh, p + Imath::V3d(grain.origin));
        EXPECT_LE(double(grain.distance.at(Vec3(p))), truth + 0.01 * grain.radius);
    }
}

TEST(Body, GradientPointsAwayFromTheSurface) {
    const Body sphere = *body_of(component_mesh("sphere", {{"radius", 0.5}}));
    Vec3 gradient;
    sphere.distance.at({0.3F, 0.4F, 0.0F}, gradient);
    EXPECT_NEAR(double((gradient - Vec3(0.6F, 0.8F, 0)).length()), 0, 0.03);
}

TEST(Body, BallsAreInsideAndFillIt) {
    const Body grain = *body_of(rice());
    const Mesh& mesh = *grain.mesh;
    EXPECT_GE(grain.balls.size(), 10U);
    EXPECT_LE(grain.balls.size(), 30U);
    for (const Ball& ball : grain.balls)
        EXPECT_LE(double(ball.radius),
                  -tests::signed_distance(mesh, Imath::V3d(ball.centre + grain.origin)) +
                      0.01 * grain.radius);
    int inside = 0;
    for (int i = 0; i < 4000; ++i) {
        Random random(4, Purpose::test, std::uint64_t(i));
        const Box3 box = bounds(mesh);
        Vec3 p;
        for (int axis = 0; axis < 3; ++axis)
            p[axis] =
                static_cast<float>(random.uniform(double(box.min[axis]), double(box.max[axis])));
        p -= grain.origin;
        if (double(grain.distance.at(p)) > -0.15 * grain.radius)
            continue;
        ++inside;
        EXPECT_TRUE(std::any_of(grain.balls.begin(), grain.balls.end(), [&](const Ball& ball) {
            return (p - ball.centre).length() < ball.radius;
        }));
    }
    EXPECT_GT(inside, 500);
}

// Every point of the surface is within about 2% of the radius of the probe.
TEST(Body, ProbeReachesTheSurface) {
    for (const Mesh& mesh : {rice(), component_mesh("box", {{"rounding", 0.0}})}) {
        const Body body = *body_of(mesh);
        for (const Ball& sample : body.samples.balls()) {
            const auto felt = [&](const Vec3& p) { return (p - sample.centre).length(); };
            if (std::abs(body.distance.at(sample.centre)) > 0.02 * body.radius)
                continue; // a ball's centre
            EXPECT_GT(body.probe.depth_where(felt, -1), -0.021 * body.radius);
        }
    }
}

TEST(Body, DepthIsThatOfTheDeepestBall) {
    const Body grain = *body_of(rice());
    for (int i = 0; i < 100; ++i) {
        Random random(5, Purpose::test, std::uint64_t(i));
        RelativePose there;
        there.rotation = Imath::M33f();
        for (int axis = 0; axis < 3; ++axis)
            there.offset[axis] = static_cast<float>(random.uniform(-3, 3) * grain.radius);
        float deepest = 0;
        for (const Ball& ball : grain.probe.balls())
            deepest = std::max(deepest, ball.radius - grain.distance.at(there(ball.centre)));
        EXPECT_EQ(grain.probe.depth_in(grain.distance, there, 0), deepest);
    }
}

TEST(Body, OpenMeshIsRefusedWithItsBorder) {
    try {
        body_of(component_mesh("plane", {}));
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("4 boundary edges"), std::string::npos)
            << error.what();
    }
}

TEST(Body, SheetHasTwoSides) {
    const Body sheet = *body_of(component_mesh("plane", {{"size", 0.02}}), 0.001);
    EXPECT_DOUBLE_EQ(sheet.radius, 0.0005);
    for (const float side : {-1.0F, 1.0F})
        EXPECT_NEAR(double(sheet.distance.at({0, side * 0.0007F, 0})), 0.0002, 1e-6);
    EXPECT_LT(sheet.distance.at({0, 0, 0}), 0);
}

} // namespace
} // namespace scree
