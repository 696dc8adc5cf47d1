// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/error.h"
#include "core/random.h"
#include "tests/support/piles.h"

#include <gtest/gtest.h>

namespace scree {
namespace {

using tests::component_mesh;
using tests::prepared;

Mesh rice() { return component_mesh("rice", {}); }

TEST(PileComponent, LargestBallOfABox) {
    const PileComponent box = prepared(component_mesh(
        "box", {{"width", 0.06}, {"height", 0.02}, {"depth", 0.03}, {"rounding", 0.0}}));
    EXPECT_NEAR(box.radius, 0.01, 1e-5);
    EXPECT_NEAR(double(box.origin.y), 0.01, 1e-5);
    // Anywhere along the middle, half the height away from the sides.
    EXPECT_LE(std::abs(box.origin.x), 0.02F + 1e-5F);
    EXPECT_LE(std::abs(box.origin.z), 0.005F + 1e-5F);
}

TEST(PileComponent, LargestBallOfASphere) {
    const PileComponent sphere = prepared(component_mesh("sphere", {{"radius", 0.5}}));
    EXPECT_NEAR(sphere.radius, 0.5, 0.5 * 0.005); // its facets
    EXPECT_NEAR(double((sphere.origin - Vec3(0, 0.5F, 0)).length()), 0, 0.5 * 0.01);
    EXPECT_NEAR(sphere.reach, 0.5, 0.5 * 0.01);
    EXPECT_DOUBLE_EQ(sphere.distribution_radius, sphere.radius / 2);
}

TEST(PileComponent, LargestBallOfAGrainIsNoSmallerThanAnyFoundByTrying) {
    const PileComponent grain = prepared(rice());
    const Mesh& mesh = *grain.prototype.mesh();
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

TEST(PileComponent, DistanceAgainstBruteForce) {
    for (const Mesh& mesh : {rice(), component_mesh("torus", {})}) {
        const PileComponent component = prepared(mesh);
        for (int i = 0; i < 300; ++i) {
            Random random(2, Purpose::test, std::uint64_t(i));
            const Box3 box = bounds(mesh);
            Imath::V3d p;
            for (int axis = 0; axis < 3; ++axis)
                p[axis] = random.uniform(double(box.min[axis]) - component.radius,
                                         double(box.max[axis]) + component.radius);
            const double truth = tests::signed_distance(mesh, p);
            const auto found = double(component.distance.at(Vec3(p) - component.origin));
            const double step = component.distance.step();
            if (truth > 0.9 * step) // perhaps outside of the grid
                EXPECT_LE(found, truth + 0.01 * component.radius);
            else if (truth > -component.radius / 2) // off the medial axis
                EXPECT_NEAR(found, truth, 0.01 * component.radius);
            else
                EXPECT_NEAR(found, truth, step);
        }
    }
}

TEST(PileComponent, DistanceFarAwayIsABoundFromBelow) {
    const PileComponent grain = prepared(rice());
    for (int i = 0; i < 100; ++i) {
        Random random(3, Purpose::test, std::uint64_t(i));
        const Imath::V3d p(random.uniform(-0.02, 0.02), random.uniform(-0.02, 0.02),
                           random.uniform(-0.02, 0.02));
        const double truth =
            tests::signed_distance(*grain.prototype.mesh(), p + Imath::V3d(grain.origin));
        EXPECT_LE(double(grain.distance.at(Vec3(p))), truth + 0.01 * grain.radius);
    }
}

TEST(PileComponent, GradientPointsAwayFromTheSurface) {
    const PileComponent sphere = prepared(component_mesh("sphere", {{"radius", 0.5}}));
    Vec3 gradient;
    sphere.distance.at({0.3F, 0.4F, 0.0F}, gradient);
    EXPECT_NEAR(double((gradient - Vec3(0.6F, 0.8F, 0)).length()), 0, 0.03);
}

TEST(PileComponent, BallsAreInsideAndFillIt) {
    const PileComponent grain = prepared(rice());
    const Mesh& mesh = *grain.prototype.mesh();
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

// A small ball that is pushed in from any side is felt to within 2% of the radius.
TEST(PileComponent, ProbeFeelsWhatReachesIn) {
    for (const Mesh& mesh : {rice(), component_mesh("box", {{"rounding", 0.0}})}) {
        const PileComponent component = prepared(mesh);
        for (const Ball& sample : component.samples.balls()) {
            const auto felt = [&](const Vec3& p) { return (p - sample.centre).length(); };
            if (std::abs(component.distance.at(sample.centre)) > 0.02 * component.radius)
                continue; // a ball's centre
            EXPECT_GT(component.probe.depth_where(felt, -1), -0.021 * component.radius);
        }
    }
}

TEST(PileComponent, DepthIsThatOfTheDeepestBall) {
    const PileComponent grain = prepared(rice());
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

TEST(PileComponent, OpenMeshIsRefusedWithItsBorder) {
    try {
        prepared(component_mesh("plane", {}));
        FAIL();
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("4 boundary edges"), std::string::npos)
            << error.what();
    }
}

TEST(PileComponent, SheetHasTwoSides) {
    const PileComponent sheet = prepared(component_mesh("plane", {{"size", 0.02}}), 0.001);
    EXPECT_DOUBLE_EQ(sheet.radius, 0.0005);
    for (const float side : {-1.0F, 1.0F})
        EXPECT_NEAR(double(sheet.distance.at({0, side * 0.0007F, 0})), 0.0002, 1e-6);
    EXPECT_LT(sheet.distance.at({0, 0, 0}), 0);
}

} // namespace
} // namespace scree
