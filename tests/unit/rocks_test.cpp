// SPDX-License-Identifier: GPL-3.0-or-later
// generator.rocks: the facts of its methods.
#include "generators/rocks/rocks_generator.h"
#include "generators/table.h"
#include "shapes/field/plain_fields.h"
#include "tests/support/plugin_params.h"
#include "tests/support/regions.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace scree {

namespace {

Params size_class(double radius, double share) {
    const Plugin<Generator> plugin = rocks_plugin();
    Params params;
    for (const ParamSpec& spec : plugin.params)
        if (spec.name == "sizes")
            params = tests::defaults(spec.fields, "generator.rocks.sizes[1]");
    params.set("radius", radius);
    params.set("share", share);
    params.set("height", Vec3(0.5F * float(radius), 0, 0));
    return params;
}

Value sizes(std::vector<Params> classes) {
    return std::make_shared<const std::vector<Params>>(std::move(classes));
}

/// Fig. 1 of Sakurai & Miyata; a pixel is a millimetre.
std::map<std::string, Value> figure_1(const std::string& method) {
    return {
        {"method", method},
        {"domain", tests::shared_square(0.953)},
        {"sizes", sizes({size_class(0.09, 0.2), size_class(0.03, 0.24), size_class(0.01, 0.56)})}};
}

Aggregate bake(const std::map<std::string, Value>& values) {
    return tests::make(generator_table(), "rocks", values)({});
}

double fact(const Aggregate& aggregate, const std::string& name) {
    const auto found = std::find_if(aggregate.facts.begin(), aggregate.facts.end(),
                                    [&](const auto& f) { return f.first == name; });
    return found == aggregate.facts.end() ? std::nan("") : found->second;
}

} // namespace

TEST(RocksPaper, HasThePapersSitesAndLeavesGaps) {
    const Aggregate rocks = bake(figure_1("paper"));
    EXPECT_EQ(fact(rocks, "sites_1"), 100);
    EXPECT_EQ(fact(rocks, "sites_2"), 899);
    EXPECT_EQ(fact(rocks, "sites_3"), 8095);
    EXPECT_NEAR(fact(rocks, "share_1"), 0.2, 0.02);
    EXPECT_NEAR(fact(rocks, "share_2"), 0.24, 0.01);
    EXPECT_GT(fact(rocks, "gap"), 0.1); // which the mosaic closes
    for (const Prototype& prototype : rocks.prototypes)
        EXPECT_TRUE(inspect(*prototype.mesh()).closed()) << prototype.name;
}

TEST(RocksPaper, FullExclusionHasNoRoomForItsSites) {
    std::map<std::string, Value> values = figure_1("paper");
    values["sizes"] = sizes({size_class(0.09, 0.5)});
    values["exclusion"] = std::string("full");
    EXPECT_LT(fact(bake(values), "sites_1"), 90); // of 100: disks jam at 0.547, not 0.7
}

TEST(RocksMosaic, HasItsSharesAndNoGap) {
    const Aggregate rocks = bake(figure_1("mosaic"));
    EXPECT_NEAR(fact(rocks, "share_1"), 0.2, 1e-3 * 0.2);
    EXPECT_NEAR(fact(rocks, "share_2"), 0.24, 1e-3 * 0.24);
    EXPECT_NEAR(fact(rocks, "share_3"), 0.56, 1e-3 * 0.56);
    EXPECT_NEAR(fact(rocks, "gap"), 0, 1e-9);
    EXPECT_LE(fact(rocks, "cell_error"), 1e-4);
}

TEST(RocksMosaic, LeavesBareGroundForSharesBelowOne) {
    std::map<std::string, Value> values = figure_1("mosaic");
    values["sizes"] = sizes({size_class(0.09, 0.4), size_class(0.03, 0.3)});
    const Aggregate rocks = bake(values);
    EXPECT_NEAR(fact(rocks, "share_1") + fact(rocks, "share_2"), 0.7, 1e-3);
    EXPECT_NEAR(fact(rocks, "gap"), 0, 1e-9); // of cells, of which 0.3 stay bare
}

TEST(RocksDropped, MeasuresStayWithinTheirBounds) {
    const Aggregate rocks = bake({{"domain", tests::shared_square(3)},
                                  {"smallest", 0.08},
                                  {"largest", 0.6},
                                  {"cover", 0.9},
                                  {"burial", 0.1},
                                  {"triangles", std::int64_t{320}},
                                  {"measure", std::int64_t{400}}});
    const double count = fact(rocks, "count");
    EXPECT_GT(count, 500);
    EXPECT_LT(fact(rocks, "left_out"), 0.05 * count);
    EXPECT_LE(fact(rocks, "depth_99"), 0.002);
    EXPECT_LE(fact(rocks, "depth_max"), 0.01);
    EXPECT_LE(fact(rocks, "gap_99"), 0.005);
}

TEST(RocksDropped, LargerRocksLieLowerOnScree) {
    const Aggregate rocks = bake({{"preset", std::string("scree")},
                                  {"domain", tests::shared_square(10)},
                                  {"smallest", 0.2},
                                  {"largest", 1.0},
                                  {"cover", 0.5},
                                  {"measure", std::int64_t{1}}});
    EXPECT_LE(fact(rocks, "size_height_correlation"), -0.3) << rocks.instances.size();
}

TEST(RocksDropped, LargerRocksLieWhereTheFieldIsGreater) {
    // The field rises by 1 from one side to the other, and ln D with it.
    const Aggregate rocks =
        bake({{"domain", tests::shared_square(10)},
              {"smallest", 0.1},
              {"largest", 1.0},
              {"size", std::shared_ptr<const Field>(std::make_shared<GradientField>(
                           Vec2(-5, 0), Vec2(5, 0), Range{0, 1}, false))},
              {"cover", 0.5}});
    double x = 0, y = 0, xx = 0, xy = 0;
    const auto n = double(rocks.instances.size());
    for (const Instance& instance : rocks.instances) {
        const double at = instance.world_from_object[3][0] / 10;
        const double size = std::log(instance.scale);
        x += at;
        y += size;
        xx += at * at;
        xy += at * size;
    }
    const double slope = (n * xy - x * y) / (n * xx - x * x);
    // The weight is not small at the ends, where the mean shifts less than its slope at 0.
    EXPECT_GT(slope, 0.6) << n;
    EXPECT_LT(slope, 1.2) << n;
}

TEST(RocksDropped, NoDensityNoRocks) {
    const Aggregate rocks = bake({{"domain", tests::shared_square(2)},
                                  {"smallest", 0.1},
                                  {"largest", 0.4},
                                  {"density", 0.0}});
    EXPECT_EQ(rocks.instances.size(), 0U);
}

TEST(RocksDropped, SameSeedSameRocks) {
    const std::map<std::string, Value> values{{"domain", tests::shared_square(2)},
                                              {"smallest", 0.1},
                                              {"largest", 0.4},
                                              {"triangles", std::int64_t{320}}};
    const Aggregate once = bake(values);
    const Aggregate again = bake(values);
    ASSERT_EQ(once.instances.size(), again.instances.size());
    for (std::size_t i = 0; i < once.instances.size(); ++i)
        EXPECT_EQ(once.instances[i].world_from_object, again.instances[i].world_from_object);
}

} // namespace scree
