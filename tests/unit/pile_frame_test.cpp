// SPDX-License-Identifier: GPL-3.0-or-later
// Which frame the parameters of generator.pile are in.
#include "tests/support/piles.h"

#include <gtest/gtest.h>

namespace scree {
namespace {

using tests::component_mesh;

Value record(Params params) {
    return std::make_shared<const std::vector<Params>>(1, std::move(params));
}

/// A pile on a ball that depends on a floor, a cut and a flow, none of them symmetric to the ball.
Params shaped_pile() {
    Params params = tests::pile_params(component_mesh("sphere", {{"radius", 0.01}}),
                                       {tests::pile_component(component_mesh("rice", {}))});
    params.set("cover", 0.6);
    params.set("adhesive", false);
    params.set("support", std::string("remove"));
    params.set("floor", 0.006);
    Params cut("generator.pile.cut", {"scene.lua", 11});
    cut.set("normal", Vec3(1, 0, 2));
    cut.set("point", Vec3(0.003F, 0, 0));
    params.set("cut", record(std::move(cut)));
    Params flow("generator.pile.flow", {"scene.lua", 12});
    flow.set("about", Vec3(0.2F, 1, 0));
    flow.set("centre", Vec3(0.004F, 0, -0.002F));
    params.set("frame", std::string("flow"));
    params.set("flow", record(std::move(flow)));
    return params;
}

/// Bakes the pile at the origin and elsewhere; expects the same pile, moved.
void expect_moved_alike(Params params) {
    const Aggregate here = pile_plugin().make(params)({});
    const WideVec3 position(0.3, -0.2, 0.5);
    params.set("position", position);
    params.set("turn", 0.7);
    const Aggregate there = pile_plugin().make(params)({});
    const WideMatrix world =
        WideMatrix().setAxisAngle(WideVec3(0, 1, 0), 0.7) * WideMatrix().setTranslation(position);
    ASSERT_GT(here.instances.size(), 10U);
    ASSERT_EQ(there.instances.size(), here.instances.size());
    for (std::size_t i = 0; i < here.instances.size(); ++i)
        EXPECT_TRUE(there.instances[i].world_from_object.equalWithAbsError(
            here.instances[i].world_from_object * world, 1e-6))
            << i;
}

TEST(PileFrame, FloorCutAndFlowMoveWithTheTarget) {
    const Params params = shaped_pile();
    expect_moved_alike(params);
    // The floor does make a difference.
    const std::size_t count = pile_plugin().make(params)({}).instances.size();
    for (const auto& [name, value] : std::vector<std::pair<std::string, Value>>{
             {"floor", 0.02}, {"support", std::string("none")}}) {
        Params other = params;
        other.set(name, value);
        EXPECT_NE(pile_plugin().make(other)({}).instances.size(), count) << name;
    }
}

TEST(PileFrame, GlobalAxesMoveWithTheTarget) {
    Params params = tests::pile_params(component_mesh("sphere", {{"radius", 0.01}}),
                                       {tests::pile_component(component_mesh("rice", {}))});
    params.set("frame", std::string("global"));
    params.set("rotation", Vec3(0));
    expect_moved_alike(params);
}

} // namespace
} // namespace scree
