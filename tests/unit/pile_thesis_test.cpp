// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "generators/pile/pile_sites.h"
#include "generators/pile/thesis_method.h"
#include "geometry/bodies/corner_depth.h"
#include "geometry/bodies/dependency_levels.h"
#include "geometry/bodies/golden_section.h"
#include "tests/support/piles.h"

#include <gtest/gtest.h>

#include <set>

namespace scree {
namespace {

using tests::kind_of;

Mesh cube(double size) {
    return tests::component_mesh(
        "box", {{"width", size}, {"height", size}, {"depth", size}, {"rounding", 0.0}});
}

TEST(PileThesis, GoldenSectionFindsTheOnlyMinimum) {
    for (const double at : {0.0, 0.123, 0.5, 0.987, 1.0}) {
        const auto cost = [at](double t) { return std::abs(t - at); };
        // 15 steps leave 0.618^15 of the range.
        EXPECT_NEAR(golden_section(cost, 0, 1, 15), at, 1e-3);
    }
}

TEST(PileThesis, GoldenSectionOfAJumpIsNoWorseThanEnds) {
    // As in eq. 4.1: a high cost while there is overlap, then a cost that grows with the height.
    const auto cost = [](double t) { return (t < 0.3 ? 1.3 - t : 0) + t; };
    const double found = golden_section(cost, 0, 1, 15);
    EXPECT_GE(found, 0.3);
    EXPECT_NEAR(found, 0.3, 1e-3);
}

TEST(PileThesis, LevelsKeepOrder) {
    constexpr std::uint32_t count = 200;
    std::vector<std::vector<std::uint32_t>> neighbours(count);
    for (std::uint32_t i = 0; i < count; ++i)
        for (std::uint32_t j = 0; j < i; ++j)
            if (Random(1, Purpose::test, i * count + j).uniform() < 0.03) {
                neighbours[i].push_back(j);
                neighbours[j].push_back(i);
            }
    std::vector<std::size_t> level(count, count);
    const auto levels = dependency_levels(neighbours);
    std::size_t all = 0;
    for (std::size_t l = 0; l < levels.size(); ++l)
        for (const std::uint32_t i : levels[l]) {
            level[i] = l;
            ++all;
        }
    EXPECT_EQ(all, count);
    for (std::uint32_t i = 0; i < count; ++i)
        for (const std::uint32_t j : neighbours[i])
            EXPECT_TRUE(j < i ? level[j] < level[i] : level[i] < level[j]);
}

TEST(PileThesis, DepthsInBallsAreThoseOfAllCorners) {
    const Mesh grain = tests::component_mesh("rice", {});
    const CornerDepth corners(grain.positions, 0.0002, 0.001);
    const Box3 box = bounds(grain);
    Random random(1, Purpose::test);
    const auto coordinate = [&](int axis) { // farther out than balls of this size reach in
        return static_cast<float>(
            random.uniform(double(box.min[axis]) - 0.003, double(box.max[axis]) + 0.003));
    };
    int inside = 0;
    for (int k = 0; k < 20000; ++k) {
        const Ball ball{{coordinate(0), coordinate(1), coordinate(2)},
                        static_cast<float>(random.uniform(0.0, 0.001))};
        float deepest = std::numeric_limits<float>::lowest();
        for (const Vec3& p : grain.positions)
            deepest = std::max(deepest, ball.radius - (p - ball.centre).length());
        EXPECT_GE(corners.bound(ball), std::min(deepest, 0.0F) - 1e-7F);
        if (deepest <= 0)
            continue;
        ++inside;
        EXPECT_GE(corners.bound(ball), deepest - 1e-7F);
        EXPECT_LE(corners.bound(ball),
                  deepest + 0.0004F); // a cell's diagonal and rounding
        EXPECT_FLOAT_EQ(corners.depth(ball, 0), deepest);
        EXPECT_EQ(corners.depth(ball, deepest * 2), deepest * 2);
    }
    EXPECT_GT(inside, 500);
}

// Eq. 4.1 and 4.2 by brute force: all vertices, all balls, one component after the other.
struct Plain {
    std::span<const PileKind> kinds;
    std::span<const BodySite> sites;
    std::vector<double> heights;
    std::vector<bool> gone;
    double overlap;

    double f(std::size_t i, double t) const {
        const Body& own = *kinds[sites[i].body].body;
        double most = 0;
        const Pose pose = sites[i].at(t).pose;
        for (const Vec3& vertex : own.mesh->positions) {
            const Imath::V3d x =
                Imath::V3d((vertex - own.origin) * pose.world_from_body) + pose.centre;
            for (std::size_t j = 0; j < sites.size(); ++j) {
                if (j == i || gone[j])
                    continue;
                const Pose other = sites[j].at(heights[j]).pose;
                for (const Ball& ball : kinds[sites[j].body].body->balls) {
                    const Imath::V3d p =
                        Imath::V3d(ball.centre * other.world_from_body) + other.centre;
                    most = std::max(most, double(ball.radius) - (x - p).length());
                }
            }
        }
        return most - overlap * own.radius;
    }

    void refine(std::size_t i) {
        const double range = kinds[sites[i].body].range();
        const auto cost = [&](double t) {
            const double h = f(i, t);
            return (h > 0 ? h + range : 0) + t;
        };
        heights[i] = golden_section(cost, 0, range, 15);
    }
};

TEST(PileThesis, RefinesAsTheEquationsSay) {
    const std::vector<PileKind> kinds{kind_of(cube(0.004), 1.2, 2)};
    const Mesh target = tests::component_mesh("sphere", {{"radius", 0.006}});
    const PileTurns turns{.kinds = kinds, .frame = PileFrame::surface, .seed = 1};
    const std::vector<BodySite> sites = pile_sites(target, turns, {});
    ASSERT_GT(sites.size(), 10U);
    for (const double overlap : {0.0, 0.2}) {
        Plain plain{kinds, sites, std::vector<double>(sites.size(), 0.0),
                    std::vector<bool>(sites.size(), false), overlap};
        for (std::size_t i = 0; i < sites.size(); ++i)
            plain.refine(i);
        PlacedBodies pile(bodies_of(kinds));
        place_by_thesis(pile, kinds, sites, {.overlap = overlap, .removal = {}}, {});
        ASSERT_EQ(pile.all.size(), sites.size());
        for (std::size_t i = 0; i < sites.size(); ++i)
            EXPECT_NEAR(pile.all[i].height, plain.heights[i], 1e-3 * kinds[0].range());

        // Removal, one after the other in the same order.
        for (std::size_t i = 0; i < sites.size(); ++i)
            plain.gone[i] = plain.f(i, plain.heights[i]) > 0.1 * kinds[0].body->radius;
        PlacedBodies rest(bodies_of(kinds));
        place_by_thesis(rest, kinds, sites, {.overlap = overlap, .removal = 0.1}, {});
        const auto left =
            static_cast<std::size_t>(std::count(plain.gone.begin(), plain.gone.end(), false));
        EXPECT_EQ(rest.all.size(), left);
        EXPECT_LT(left, sites.size());
        EXPECT_GT(left, 0U);
    }
}

TEST(PileThesis, SmallOnesNextToLargeOnesGo) {
    const std::vector<PileKind> kinds{kind_of(cube(0.002), 1, 2), kind_of(cube(0.01), 2, 1)};
    const Mesh target = tests::component_mesh("sphere", {{"radius", 0.03}});
    const PileTurns turns{.kinds = kinds, .frame = PileFrame::surface, .seed = 2};
    const std::vector<BodySite> sites = pile_sites(target, turns, {});
    std::vector<Imath::V3d> expected;
    for (const BodySite& site : sites) {
        bool near = false;
        for (const BodySite& large : sites)
            near = near ||
                   (site.body == 0 && large.body == 1 &&
                    (site.position - large.position).length() <= kinds[1].distribution_radius());
        if (!near)
            expected.push_back(site.position);
    }
    const std::vector<BodySite> merged = merge_large_to_small(kinds, sites);
    ASSERT_EQ(merged.size(), expected.size());
    EXPECT_LT(merged.size(), sites.size());
    for (std::size_t i = 0; i < merged.size(); ++i)
        EXPECT_EQ(merged[i].position, expected[i]);
}

TEST(PileThesis, SitesKeepTwoRadiiApart) {
    const std::vector<PileKind> kinds{kind_of(cube(0.004), 1, 2)};
    const Mesh target = tests::component_mesh("sphere", {{"radius", 0.02}});
    const PileTurns turns{.kinds = kinds, .frame = PileFrame::surface, .seed = 3};
    const std::vector<BodySite> sites = pile_sites(target, turns, {});
    for (std::size_t i = 0; i < sites.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_GE((sites[i].position - sites[j].position).length(),
                      kinds[0].body->radius * (1 - 1e-9)); // 2 r = R
}

TEST(PileThesis, LeavesWhatItsMeasureDoesNotSee) {
    Params params = tests::pile_params(tests::component_mesh("sphere", {{"radius", 0.005}}),
                                       {tests::pile_component(tests::component_mesh("rice", {}))});
    params.set("method", std::string("thesis"));
    params.set("spacing", 1.8);
    const Aggregate pile = pile_plugin().make(params)({});
    EXPECT_GT(tests::fact(pile, "volume_overlap"), 0.1);
}

} // namespace
} // namespace scree
