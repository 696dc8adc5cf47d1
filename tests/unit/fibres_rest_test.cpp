// SPDX-License-Identifier: GPL-3.0-or-later
// generator.fibres: fibres that fall and come to rest.
#include "generators/fibres/rest.h"
#include "tests/support/fibres.h"

#include <gtest/gtest.h>

namespace scree {
namespace {

using tests::bake_fibres;
using tests::fact;
using tests::FibreValues;
using tests::strands_of;

constexpr double radius = 0.01;

/// Straight rods of 4 segments from a to b.
fibres::Rods straight_rods(const std::vector<std::array<Vec3, 2>>& ends) {
    fibres::Rods rods{.segments = 4};
    for (const auto& [a, b] : ends) {
        for (int v = 0; v <= 4; ++v)
            rods.points.push_back(a + (b - a) * (float(v) / 4));
        rods.lengths.push_back((b - a).length() / 4);
    }
    rods.radii.assign(5, float(radius));
    rods.frames.resize(4 * ends.size());
    rods.rest.resize(3 * ends.size());
    fibres::take_shapes_as_rest(rods);
    return rods;
}

/// A wide slope through the origin that falls towards -x at the angle.
std::shared_ptr<const Mesh> slope(double angle) {
    Mesh mesh;
    const auto x = float(10 * std::cos(angle));
    const auto y = float(10 * std::sin(angle));
    mesh.positions = {{-x, -y, -10}, {-x, -y, 10}, {x, y, 10}, {x, y, -10}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return std::make_shared<const Mesh>(mesh);
}

/// How far a rod that was put on a slope goes down it [radii], and whether it came to rest.
std::pair<double, bool> slide(double angle, double friction, bool along) {
    const Vec3 down = -Vec3(float(std::cos(angle)), float(std::sin(angle)), 0);
    const Vec3 at = Vec3(float(-std::sin(angle)), float(std::cos(angle)), 0) * float(radius);
    const Vec3 half = (along ? down : Vec3(0, 0, 1)) * 0.2F;
    fibres::Rods rods = straight_rods({{at - half, at + half}});
    fibres::Boundary boundary;
    boundary.stay_outside(slope(angle));
    fibres::ContactSettings settings;
    settings.radius = radius;
    settings.friction = friction;
    const fibres::RestResult result = come_to_rest(rods, boundary, settings, {});
    return {double((rods.points[2] - at).dot(down)) / radius, result.at_rest};
}

TEST(FibreRest, FollowsCoulombsLawOnASlope) {
    for (const double angle : {0.2, 0.5})
        for (const bool along : {false, true}) {
            const auto [held, rests] = slide(angle, 1.05 * std::tan(angle), along);
            EXPECT_TRUE(rests);
            EXPECT_LE(held, 0.5) << angle << along;
            const auto [slid, stops] = slide(angle, 0.5 * std::tan(angle), along);
            EXPECT_FALSE(stops);
            EXPECT_GE(slid, 10) << angle << along;
        }
}

TEST(FibreRest, AStackOfCrossedRodsStands) {
    // Four layers of two rods each, every layer across the one before: what holds is contact alone.
    std::vector<std::array<Vec3, 2>> ends;
    for (int layer = 0; layer < 4; ++layer)
        for (const float side : {-0.03F, 0.03F}) {
            const float y = float(radius) * (1 + 2 * float(layer)) + 0.002F * float(layer + 1);
            const Vec3 across = layer % 2 == 0 ? Vec3(0, y, side) : Vec3(side, y, 0);
            const Vec3 half = layer % 2 == 0 ? Vec3(0.05F, 0, 0) : Vec3(0, 0, 0.05F);
            ends.push_back({across - half, across + half});
        }
    fibres::Rods rods = straight_rods(ends);
    const std::vector<Vec3> before = rods.points;
    fibres::Boundary boundary;
    boundary.stay_above(0);
    fibres::ContactSettings settings;
    settings.radius = radius;
    settings.friction = 0.5;
    settings.stiffness = 1;
    const fibres::RestResult result = come_to_rest(rods, boundary, settings, {});
    EXPECT_TRUE(result.at_rest);
    for (std::size_t i = 0; i < rods.points.size(); ++i) {
        const std::size_t layer = i / 10;
        const Vec3 moved = rods.points[i] - before[i];
        EXPECT_LE(std::hypot(moved.x, moved.z), 0.1 * radius) << i;
        EXPECT_NEAR(double(rods.points[i].y), radius * (1 + 2 * double(layer)), 0.1 * radius) << i;
    }
}

/// Noodles over a floor.
FibreValues noodles() {
    return {{"target", tests::ball_target(0.3)},
            {"floor", 0.0},
            {"gravity", true},
            {"count", std::int64_t{60}},
            {"length", Range{0.5, 0.7}},
            {"segments", std::int64_t{24}},
            {"radius", radius},
            {"theta", Range{radians(2), radians(12)}},
            {"phi", Range{radians(-20), radians(20)}}};
}

TEST(FibreRest, LeavesAHeapThatLiesOnTheFloorAndDoesNotOverlap) {
    const Aggregate heap = bake_fibres(noodles());
    const auto strands = strands_of(heap);
    EXPECT_LT(fact(heap, "mean_step"), 0.001);
    std::vector<double> depths = tests::contact_depths(*strands, radius);
    ASSERT_GT(depths.size(), 100U);
    EXPECT_LE(*std::ranges::max_element(depths), 0.0501);
    double low = 1;
    double high = 0;
    double mean = 0;
    for (const Vec3& p : strands->points) {
        low = std::min(low, double(p.y));
        high = std::max(high, double(p.y));
        mean += double(p.y) / double(strands->points.size());
    }
    EXPECT_NEAR(low, radius, 0.06 * radius);
    EXPECT_LT(mean, 8 * radius); // the ball's middle is at 30
    EXPECT_LE(tests::stretch(*strands), 1e-4);
    // Each touches the floor or another: none floats.
    std::vector<int> touches(strands->count());
    for (std::size_t f = 0; f < strands->count(); ++f)
        for (const Vec3& p : tests::strand(*strands, f))
            touches[f] += double(p.y) < 1.1 * radius ? 1 : 0;
    for (const auto& [f, g] : tests::touching_fibres(*strands, 2.2 * radius)) {
        ++touches[f];
        ++touches[g];
    }
    for (std::size_t f = 0; f < touches.size(); ++f)
        EXPECT_GE(touches[f], 2) << f;
}

TEST(FibreRest, KeepsOutOfAContainer) {
    FibreValues values = noodles();
    // A box without a lid, as a sheet of five sides.
    Mesh box = tests::component_mesh("box", {{"width", 0.8}, {"height", 0.6}, {"depth", 0.8}});
    std::erase_if(box.triangles, [&](const auto& t) {
        return std::ranges::all_of(t, [&](std::uint32_t v) { return box.positions[v].y > 0.59F; });
    });
    values["container"] = SharedObject(std::make_shared<const Mesh>(box));
    values["length"] = Range{0.2, 0.4};
    values["segments"] = std::int64_t{9};
    const auto strands = strands_of(bake_fibres(values));
    for (const Vec3& p : strands->points) {
        EXPECT_LE(std::abs(p.x), 0.4 - 0.94 * radius);
        EXPECT_LE(std::abs(p.z), 0.4 - 0.94 * radius);
        EXPECT_GE(p.y, 0.94 * radius);
    }
}

TEST(FibreRest, ThreadsDoNotChangeTheBytes) {
    FibreValues values = noodles();
    values["count"] = std::int64_t{20};
    EXPECT_EQ(tests::threads_that_differ(values, {1, 3}), 0);
}

} // namespace
} // namespace scree
