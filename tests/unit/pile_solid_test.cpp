// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/pile/fill_solid.h"
#include "geometry/mesh/offset_shells.h"
#include "tests/support/piles.h"

#include <gtest/gtest.h>

#include <set>

namespace scree {
namespace {

using tests::component_mesh;
using tests::fact;

Mesh ball(double radius) { return component_mesh("sphere", {{"radius", radius}}); }

Params solid_params(double radius) {
    Params params =
        tests::pile_params(ball(radius), {tests::pile_component(component_mesh("rice", {}))});
    params.set("fill", std::string("solid"));
    params.set("rotation", Vec3(2 * pi_f));
    return params;
}

TEST(PileSolid, ShellsAreClosedAndAsDeepAsTheySay) {
    const Mesh torus = component_mesh("torus", {});
    const double step = double(bounds(torus).size().length()) / 100;
    const SignedDistanceGrid distance(torus, step);
    const std::vector<OffsetShell> shells = offset_shells(distance, 2 * step, 1000);
    ASSERT_GT(shells.size(), 2U);
    double larger = volume(torus);
    for (const OffsetShell& shell : shells) {
        EXPECT_TRUE(inspect(shell.surface).closed());
        EXPECT_GT(volume(shell.surface), 0); // it faces outwards
        EXPECT_LT(volume(shell.surface), larger);
        larger = volume(shell.surface);
        for (std::size_t i = 0; i < shell.surface.positions.size(); i += 97)
            EXPECT_NEAR(tests::signed_distance(torus, Imath::V3d(shell.surface.positions[i])),
                        -shell.depth, 0.87 * distance.step());
    }
    EXPECT_EQ(offset_shells(distance, 2 * step, 1).size(), 1U);
}

TEST(PileSolid, ShellOfABallIsASphere) {
    const SignedDistanceGrid distance(ball(0.01), 0.0003);
    const Mesh shell = level_surface(distance, -0.004);
    EXPECT_NEAR(volume(shell), 4 * pi / 3 * std::pow(0.006, 3), 0.01 * volume(shell));
    EXPECT_NEAR(area(shell), 4 * pi * std::pow(0.006, 2), 0.02 * area(shell));
    EXPECT_TRUE(level_surface(distance, -0.011).triangles.empty());
}

TEST(PileSolid, FillsTheInsideAndNothingOutside) {
    constexpr double radius = 0.012;
    Params params = solid_params(radius);
    const Aggregate skin = [&] {
        Params surface = params;
        surface.set("fill", std::string("surface"));
        return pile_plugin().make(surface)({});
    }();
    const Aggregate pile = pile_plugin().make(params)({});
    const PileKind kind = tests::kind_of(component_mesh("rice", {}), 3, 2);
    int deep = 0;
    for (const Instance& instance : pile.instances) {
        const Imath::V3d centre =
            Imath::V3d(kind.body->origin) * Imath::M44d(instance.world_from_object) -
            Imath::V3d(0, radius, 0);
        EXPECT_LE(centre.length(), radius + kind.range() + 1e-6);
        deep += centre.length() < radius - 2 * kind.body->radius;
    }
    EXPECT_GT(deep, 10);
    EXPECT_GT(pile.instances.size(), skin.instances.size() / 2);
    EXPECT_GT(fact(pile, "fill"), 0.15);
    EXPECT_LE(fact(pile, "depth_max"), 0.02);
    EXPECT_LT(fact(pile, "volume_overlap"), 0.001);

    params.set("shells", std::int64_t{1});
    EXPECT_EQ(pile_plugin().make(params)({}).instances.size(), skin.instances.size());
}

// At seed 0 the sites of one component on the surface used to be those of another on a shell.
TEST(PileSolid, NoComponentHasSitesOfAnother) {
    const PileKind kind = tests::kind_of(component_mesh("rice", {}), 3, 2);
    const std::vector<PileKind> kinds{kind, kind, kind};
    const Mesh target = ball(0.012);
    std::set<std::array<double, 3>> seen;
    std::size_t count = 0;
    const auto add = [&](const PileTurns& turns) {
        for (const BodySite& site : pile_sites(target, turns, {})) {
            seen.insert({site.position.x, site.position.y, site.position.z});
            ++count;
        }
    };
    for (const std::uint64_t seed : {0, 1}) {
        const PileTurns turns{.kinds = kinds, .seed = seed};
        add(turns);
        for (std::size_t shell = 0; shell < 3; ++shell)
            add(turns_of_shell(turns, shell));
    }
    EXPECT_GT(count, 1000U);
    EXPECT_EQ(seen.size(), count);
}

TEST(PileSolid, FilledShareOfOneBallInAnother) {
    PlacedBodies pile({tests::body_of(ball(0.005))});
    PlacedBody placed;
    placed.pose.centre = {0, 0.01, 0}; // the middle of the target
    pile.add(placed);
    EXPECT_NEAR(filled_share(pile, ball(0.01), 1), 0.125, 0.01);
}

// Leaves out what lies above a height.
void cut_at(float height, Params& params) {
    for (const ParamSpec& spec : pile_plugin().params)
        if (spec.name == "cut") {
            Params cut = tests::defaults(spec.fields, "generator.pile.cut");
            cut.set("normal", Vec3(0, 2, 0));
            cut.set("point", Vec3(0, height, 0));
            params.set("cut", std::make_shared<const std::vector<Params>>(std::vector{cut}));
        }
}

TEST(PileSolid, CountsAreOfWhatTheCutLeaves) {
    Params params =
        tests::pile_params(ball(0.01), {tests::pile_component(component_mesh("rice", {})),
                                        tests::pile_component(ball(0.001))});
    cut_at(0.002F, params);
    const Aggregate half = pile_plugin().make(params)({});
    std::array<double, 2> counted{0, 0};
    for (const Instance& instance : half.instances)
        ++counted.at(instance.prototype);
    EXPECT_GT(fact(half, "cut"), 0);
    EXPECT_EQ(fact(half, "count"), counted[0] + counted[1]);
    EXPECT_EQ(fact(half, "count_1"), counted[0]);
    EXPECT_EQ(fact(half, "count_2"), counted[1]);
}

TEST(PileSolid, CutLeavesWhatIsBelowThePlane) {
    Params params = solid_params(0.01);
    const Aggregate whole = pile_plugin().make(params)({});
    cut_at(0.01F, params);
    const Aggregate half = pile_plugin().make(params)({});
    const Vec3 origin = tests::body_of(component_mesh("rice", {}))->origin;
    std::size_t below = 0;
    for (const Instance& instance : whole.instances)
        below += (Imath::V3d(origin) * Imath::M44d(instance.world_from_object)).y <= double(0.01F);
    EXPECT_EQ(half.instances.size(), below);
    EXPECT_EQ(fact(half, "cut"), double(whole.instances.size() - below));
}

TEST(PileSolid, SameBytesOnAnyNumberOfThreads) {
    tests::expect_same_on_any_threads([] { return pile_plugin().make(solid_params(0.008))({}); });
}

} // namespace
} // namespace scree
