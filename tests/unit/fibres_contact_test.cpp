// SPDX-License-Identifier: GPL-3.0-or-later
// generator.fibres: what contact leaves, measured in double by code that shares nothing with it.
#include "core/random.h"
#include "formats/read_mesh.h"
#include "generators/fibres/fibre_order.h"
#include "geometry/mesh/signed_distance_grid.h"
#include "tests/support/fibres.h"
#include "tests/support/piles.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace scree {
namespace {

using fibres::order_in_space;
using tests::bake_fibres;
using tests::fact;
using tests::FibreValues;
using tests::strands_of;

/// 2,048 fibres of 32 segments that fill 6.4% of a ball of diameter 2.
constexpr double radius = 0.00645;
FibreValues wool() {
    return {{"target", tests::ball_target(1)}, {"length", Range{1, 1}}, {"radius", radius}};
}

class FibreContact : public testing::Test {
  protected:
    static void SetUpTestSuite() {
        FibreValues values = wool();
        apart = bake_fibres(values);
        values["contact"] = false;
        adjusted = bake_fibres(values);
    }
    static void TearDownTestSuite() { apart = adjusted = {}; }

    static Aggregate apart, adjusted;
};
Aggregate FibreContact::apart, FibreContact::adjusted;

TEST_F(FibreContact, LeavesNoPairDeeperThanTheTolerance) {
    EXPECT_NEAR(fact(apart, "fill"), 0.064, 0.001);
    std::vector<double> depths = tests::contact_depths(*strands_of(apart), radius);
    ASSERT_GT(depths.size(), 3000U);
    std::ranges::sort(depths);
    EXPECT_LE(depths.back(), 0.0501);
    EXPECT_LE(depths[depths.size() * 99 / 100], 0.01);
    EXPECT_NEAR(fact(apart, "deepest"), depths.back(), 1e-3);
    const std::vector<double> before = tests::contact_depths(*strands_of(adjusted), radius);
    EXPECT_GT(std::ranges::count_if(before, [](double d) { return d > 0.05; }), 3000);
}

TEST_F(FibreContact, KeepsFibresInsideAndTheirLengths) {
    const Mesh ball = tests::component_mesh("sphere", {{"radius", 1.0}});
    double most = -1;
    const auto strands = strands_of(apart);
    for (const Vec3& p : strands->points)
        if ((p - Vec3(0, 1, 0)).length() > 0.97F)
            most = std::max(most, tests::signed_distance(ball, Imath::V3d(p)));
    EXPECT_LE(most, -radius + 0.05 * radius);
    EXPECT_LE(tests::stretch(*strands), 1e-4);
}

TEST_F(FibreContact, BendsAndMovesThemLittle) {
    const auto now = strands_of(apart);
    const auto before = strands_of(adjusted);
    double moved = 0;
    double bent = 0;
    for (std::size_t f = 0; f < now->count(); ++f)
        for (std::size_t i = 1; i < 32; ++i)
            bent += std::pow(tests::joint_angle(tests::strand(*now, f), i) -
                                 tests::joint_angle(tests::strand(*before, f), i),
                             2);
    for (std::size_t i = 0; i < now->points.size(); ++i)
        moved += double((now->points[i] - before->points[i]).length2());
    EXPECT_LE(degrees(std::sqrt(bent / double(now->count() * 31))), 5);
    EXPECT_LE(std::sqrt(moved / double(now->points.size())), 2 * radius);
}

TEST(FibreOrder, NeighboursInItAreNeighboursInSpace) {
    constexpr std::size_t count = 4096;
    Random random(71, Purpose::test);
    std::vector<Vec3> places(count);
    for (Vec3& p : places)
        p = Vec3(random.uniform_float(), random.uniform_float(), random.uniform_float());
    const std::vector<std::uint32_t> order = order_in_space(places);
    std::vector<std::uint32_t> sorted = order;
    std::ranges::sort(sorted);
    for (std::uint32_t i = 0; i < count; ++i)
        ASSERT_EQ(sorted[i], i) << "each once";
    double way = 0;
    for (std::size_t i = 1; i < count; ++i)
        way += double((places[order[i]] - places[order[i - 1]]).length());
    // Points of one of 16^3 cells are 1 / 16 apart; in no order the mean is 0.66.
    EXPECT_LT(way / count, 1.5 / 16);
    EXPECT_EQ(order_in_space({}).size(), 0U);
    EXPECT_EQ(order_in_space(std::vector<Vec3>(3, Vec3(1))), (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(FibreContactOf, TheBunnyFillsItEvenly) {
    const std::string path = "/usr/share/glmark2/models/bunny.obj";
    if (!std::filesystem::exists(path))
        GTEST_SKIP() << "glmark2-data is not installed";
    auto bunny = std::make_shared<Mesh>(read_mesh(path));
    normalise_size(*bunny, 2);
    const Aggregate fibres =
        bake_fibres({{"target", SharedObject(std::shared_ptr<const Mesh>(bunny))}});
    EXPECT_NEAR(fact(fibres, "fill"), 0.064, 0.001);
    EXPECT_LE(fact(fibres, "deepest"), 0.05);
    const SignedDistanceGrid grid(*bunny, 0.02, 0, std::size_t{1} << 22, 0.1);
    std::vector<float> inside; // samples, by depth
    std::ranges::copy_if(grid.samples(), std::back_inserter(inside),
                         [](float d) { return d < -0.004F; });
    std::ranges::sort(inside);
    std::array<double, 5> shells{}; // of equal volume, from the core out
    const auto strands = strands_of(fibres);
    for (const Vec3& p : strands->points) {
        const float d = grid.at(p);
        std::size_t shell = 0;
        while (shell < 4 && d > inside[inside.size() * (shell + 1) / 5])
            ++shell;
        ++shells[shell];
    }
    for (const double count : shells)
        EXPECT_NEAR(count / double(strands->points.size()) * 5, 1, 0.15);
}

TEST(FibreThreads, DoNotChangeTheBytes) {
    FibreValues values = wool();
    values["count"] = std::int64_t{400};
    EXPECT_EQ(tests::threads_that_differ(values, {1, 2, 4, 8}), 0);
}

TEST(FibreContactOf, TaperedFibresOfVariousLengthsIsMet) {
    FibreValues values = wool();
    values["count"] = std::int64_t{800};
    values["length"] = Range{0.4, 1.2};
    values["segments"] = std::int64_t{16};
    values["taper"] = 0.3;
    values["theta"] = Range{radians(-20), radians(20)};
    values["phi"] = Range{radians(-30), radians(30)};
    const Aggregate fibres = bake_fibres(values);
    EXPECT_LE(fact(fibres, "deepest"), 0.05);
    EXPECT_LE(fact(fibres, "outside"), 0.05);
    EXPECT_LE(tests::stretch(*strands_of(fibres)), 1e-4);
}

TEST(FibreContactOf, AShapeThinnerThanAFibreAtItsRimIsMet) {
    // A lens that ends in a sharp edge, where each side sends a vertex to the other.
    FibreValues values = wool();
    values["target"] = tests::shared_component(
        "lathe",
        {{"profile", std::vector<Vec2>{
                         {0, -0.12}, {0.6, -0.06}, {1.2, 0}, {1.2, 0}, {0.6, 0.06}, {0, 0.12}}}});
    values["count"] = std::int64_t{600};
    values["length"] = Range{0.3, 0.5};
    values["segments"] = std::int64_t{16};
    const Aggregate fibres = bake_fibres(values);
    EXPECT_LE(fact(fibres, "deepest"), 0.05);
    EXPECT_LE(fact(fibres, "outside"), 0.05);
    EXPECT_LT(fact(fibres, "contact_iterations"), 500);
}

TEST(FibreContactOf, TooManyFibresIsReported) {
    FibreValues values = wool();
    values["count"] = std::int64_t{400};
    values["max_iterations"] = std::int64_t{1};
    const Aggregate fibres = bake_fibres(values);
    EXPECT_GT(fact(fibres, "deepest"), 0.05);
    EXPECT_EQ(fact(fibres, "contact_iterations"), 1);
}

} // namespace
} // namespace scree
