// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/error.h"
#include "core/random.h"
#include "generators/pile/flow_settings.h"
#include "tests/support/piles.h"

#include <gtest/gtest.h>

namespace scree {
namespace {

using tests::component_mesh;
using Vec3d = Imath::V3d;

/// An angle [deg] that grows along x.
class Slope final : public Field {
  public:
    double at(const Vec2& p) const override { return 1000 * p.x; }
    Range over(const Box2& box) const override { return {1000 * box.min.x, 1000 * box.max.x}; }
};

void expect_near(const Vec3& a, const Vec3& b) { EXPECT_LT(double((a - b).length()), 1e-5); }

TEST(PileFlow, IsProjectedToTheSurface) {
    const OrientationFlow flow = OrientationFlow::constant({2, 0, 0});
    expect_near(flow.tangent({5, 6, 7}, {0, 1, 0}), {1, 0, 0});
    const float s = std::sqrt(0.5F);
    expect_near(flow.tangent({0, 0, 0}, {s, s, 0}), {s, -s, 0});
}

TEST(PileFlow, TangentsAreUnitAndTangentEverywhere) {
    OrientationFlow flow = OrientationFlow::swirl({1, 2, 3}, {0.1F, 0, 0});
    flow.set_turn(std::make_shared<const Slope>());
    for (std::uint64_t i = 0; i < 500; ++i) {
        Random random(1, Purpose::test, i);
        Vec3 n(0);
        Vec3d p;
        for (int axis = 0; axis < 3; ++axis) {
            n[axis] = static_cast<float>(random.uniform(-1, 1));
            p[axis] = random.uniform(-1, 1);
        }
        n.normalize();
        const Vec3 u = flow.tangent(p, n);
        EXPECT_NEAR(double(u.length()), 1, 1e-5);
        EXPECT_NEAR(double(u.dot(n)), 0, 1e-5);
    }
}

TEST(PileFlow, FallsBackToTheLevelLine) {
    const OrientationFlow across = OrientationFlow::constant({0, 0, 1});
    expect_near(across.tangent({0, 0, 0}, {0, 0, 1}), {1, 0, 0}); // y cross z
    const OrientationFlow up = OrientationFlow::constant({0, 1, 0});
    expect_near(up.tangent({0, 0, 0}, {0, 1, 0}), {1, 0, 0});
    const OrientationFlow swirl = OrientationFlow::swirl({0, 1, 0}, {0, 0, 0});
    expect_near(swirl.tangent({0, 3, 0}, {0, 1, 0}), {1, 0, 0}); // on the axis
}

TEST(PileFlow, SwirlsRoundItsAxis) {
    const OrientationFlow flow = OrientationFlow::swirl({0, 3, 0}, {1, 0, 0});
    expect_near(flow.tangent({2, 5, 0}, {0, 1, 0}), {0, 0, -1});
    expect_near(flow.tangent({1, 0, 4}, {0, 0, 1}), {1, 0, 0});
}

TEST(PileFlow, FollowsAFieldOverTheGround) {
    const OrientationFlow flow = OrientationFlow::heading(std::make_shared<const Slope>());
    for (const double x : {-0.05, 0.0, 0.09}) {
        const double angle = radians(1000 * x);
        expect_near(flow.tangent({x, 0, 3}, {0, 1, 0}),
                    {static_cast<float>(std::cos(angle)), 0, static_cast<float>(std::sin(angle))});
    }
}

TEST(PileFlow, TurnsAnticlockwiseSeenFromOutside) {
    OrientationFlow flow = OrientationFlow::constant({1, 0, 0});
    flow.set_turn(std::make_shared<const Slope>());
    expect_near(flow.tangent({0.09, 0, 0}, {0, 1, 0}), {0, 0, -1});
    expect_near(flow.tangent({0.09, 0, 0}, {0, 0, 1}), {0, 1, 0});
}

Params flow_params(const char* name, Value value) {
    Params flow("generator.pile.flow", {"scene.lua", 12});
    flow.set(name, std::move(value));
    return flow;
}

Params flowing_pile(Params flow) {
    Params params = tests::pile_params(component_mesh("sphere", {{"radius", 0.02}}),
                                       {tests::pile_component(component_mesh("rice", {}))});
    params.set("frame", std::string("flow"));
    params.set("flow", std::make_shared<const std::vector<Params>>(1, std::move(flow)));
    return params;
}

TEST(PileFlow, ComponentsLieAlongIt) {
    const Aggregate pile =
        pile_plugin().make(flowing_pile(flow_params("about", Vec3(0, 1, 0))))({});
    ASSERT_GT(pile.instances.size(), 50U);
    for (const Instance& instance : pile.instances) {
        const Vec3 u = transform_direction(instance.world_from_object, {1, 0, 0});
        const Vec3 v = transform_direction(instance.world_from_object, {0, 1, 0});
        // The target is a ball that stands on the ground: v leads away from the axis, u round it.
        EXPECT_NEAR(double(u.y), 0, 1e-5);
        EXPECT_LT(double(u.dot(v)), 1e-5);
        EXPECT_GT(double(Vec3(0, 1, 0).cross(v).dot(u)), 0);
    }
}

TEST(PileFlow, RotationIsAddedToIt) {
    Params params = flowing_pile(flow_params("direction", Vec3(0, 0, 1)));
    params.set("rotation", Vec3(0, 0.5F, 0));
    double most = 0;
    for (const Instance& instance : pile_plugin().make(params)({}).instances) {
        const Vec3 u = transform_direction(instance.world_from_object, {1, 0, 0});
        const Vec3 v = transform_direction(instance.world_from_object, {0, 1, 0});
        if (std::abs(v.z) > 0.99F)
            continue; // where the flow is nearly along the normal
        const Vec3 flow = (Vec3(0, 0, 1) - v * v.z).normalized();
        const double angle = std::acos(std::min(1.0, double(u.dot(flow))));
        EXPECT_LE(angle, 0.2501);
        most = std::max(most, angle);
    }
    EXPECT_GT(most, 0.2);
}

TEST(PileFlow, MistakesAreErrors) {
    Params both = flow_params("about", Vec3(0, 1, 0));
    both.set("direction", Vec3(0, 1, 0));
    EXPECT_THROW(orientation_flow(both), Error);
    EXPECT_THROW(orientation_flow(Params("flow", {})), Error);
    EXPECT_THROW(orientation_flow(flow_params("direction", Vec3(0))), Error);
    Params centre = flow_params("direction", Vec3(0, 1, 0));
    centre.set("centre", Vec3(0));
    EXPECT_THROW(orientation_flow(centre), Error);
}

} // namespace
} // namespace scree
