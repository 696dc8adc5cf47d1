// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "render/light/light_tree.h"
#include "tests/support/sampled_directions.h"

#include <gtest/gtest.h>

namespace scree {
namespace {

Vec3 random_place(Random& random, float side) {
    return Vec3(random.uniform_float() - 0.5F, random.uniform_float() - 0.5F,
                random.uniform_float() - 0.5F) *
           side;
}

// Small lights in a room of 10 m, turned any way, bright and dim; some in a dense group.
std::vector<AreaSampler> room_lights(int count, std::uint64_t seed) {
    Random random(seed, Purpose::test);
    std::vector<AreaSampler> lights;
    for (int i = 0; i < count; ++i) {
        AreaLight light;
        light.centre = WideVec3(random_place(random, i % 3 == 0 ? 0.5F : 10.0F));
        light.edge_u = random_place(random, 1).normalized() * 0.05F;
        light.edge_v = light.edge_u.cross(random_place(random, 1)).normalized() * 0.2F;
        const float radiance = 1 + 100 * random.uniform_float() * random.uniform_float();
        light.radiance = Color(radiance, radiance, radiance);
        lights.emplace_back(light);
    }
    return lights;
}

double sum_of_irradiance(const std::vector<AreaSampler>& lights, const Vec3& point) {
    double sum = 0;
    for (const AreaSampler& light : lights)
        sum += double(light.irradiance(point));
    return sum;
}

TEST(LightTree, FewLightsAreChosenByTheirIrradiance) {
    for (const int count : {1, 2, 5, 8}) {
        const std::vector<AreaSampler> lights = room_lights(count, 1);
        const LightTree tree(lights);
        Random random(2, Purpose::test);
        for (int k = 0; k < 100; ++k) {
            const Vec3 point = random_place(random, 10);
            const double sum = sum_of_irradiance(lights, point);
            EXPECT_NEAR(double(tree.irradiance(point)), sum, 1e-5 * sum);
            for (std::size_t i = 0; i < lights.size() && sum > 0; ++i)
                EXPECT_NEAR(double(tree.probability(std::uint32_t(i), point)),
                            double(lights[i].irradiance(point)) / sum, 1e-5);
        }
    }
}

TEST(LightTree, ChoosesWithItsProbabilities) {
    const std::vector<AreaSampler> lights = room_lights(300, 3);
    const LightTree tree(lights);
    Random random(4, Purpose::test);
    for (int k = 0; k < 4; ++k) {
        const Vec3 point = random_place(random, 8);
        constexpr int trials = 200000;
        std::vector<double> observed(lights.size() + 1); // the last: no light
        std::vector<double> expected(lights.size() + 1);
        for (int i = 0; i < trials; ++i) {
            const LightTree::Choice choice = tree.choose(point, random.uniform_float());
            if (choice.probability > 0) {
                ASSERT_NEAR(choice.probability / tree.probability(choice.light, point), 1, 1e-3);
                ++observed[choice.light];
            } else {
                ++observed.back();
            }
        }
        double left = 1;
        for (std::size_t i = 0; i < lights.size(); ++i) {
            const auto probability = double(tree.probability(std::uint32_t(i), point));
            expected[i] = trials * probability;
            left -= probability;
        }
        EXPECT_GT(left, -1e-5);
        expected.back() = trials * std::max(0.0, left);
        EXPECT_EQ(test::chi_square(observed, expected, test::sampling_alpha), "");
    }
}

// Or what they give would be missing.
TEST(LightTree, CanChooseEveryLightThatReachesAPoint) {
    for (const int count : {9, 40, 1000}) {
        const std::vector<AreaSampler> lights = room_lights(count, 5);
        const LightTree tree(lights);
        Random random(6, Purpose::test);
        for (int k = 0; k < 300; ++k) {
            const Vec3 point = random_place(random, k % 2 == 0 ? 12.0F : 0.6F);
            for (std::size_t i = 0; i < lights.size(); ++i)
                if (lights[i].irradiance(point) > 0) {
                    ASSERT_GT(tree.probability(std::uint32_t(i), point), 0) << count << " " << i;
                }
        }
    }
}

// The second moment of irradiance / probability over the squared sum: 1 for probabilities in
// proportion to the irradiance, on average 21 for equal ones here.
TEST(LightTree, ChoosesNearlyInProportionToTheIrradiance) {
    const std::vector<AreaSampler> lights = room_lights(500, 7);
    const LightTree tree(lights);
    Random random(8, Purpose::test);
    double mean = 0;
    double mean_of_equal = 0;
    constexpr int points = 400;
    for (int k = 0; k < points; ++k) {
        const Vec3 point = random_place(random, 10);
        const double sum = sum_of_irradiance(lights, point);
        for (std::size_t i = 0; i < lights.size(); ++i) {
            const auto irradiance = double(lights[i].irradiance(point));
            if (irradiance > 0)
                mean += irradiance * irradiance /
                        double(tree.probability(std::uint32_t(i), point)) / (sum * sum) / points;
            mean_of_equal += irradiance * irradiance * double(lights.size()) / (sum * sum) / points;
        }
    }
    EXPECT_LT(mean, 2.5);
    EXPECT_GT(mean_of_equal, 4 * mean);
}

TEST(LightTree, LightsAtOnePlaceAndNone) {
    const Vec3 point(1.0F, 2.0F, 3.0F);
    const LightTree none(std::vector<AreaSampler>{});
    EXPECT_EQ(none.irradiance(point), 0);
    EXPECT_EQ(none.choose(point, 0.5F).probability, 0);
    AreaLight light;
    light.centre = {1, 5, 3};
    const std::vector<AreaSampler> same(100, AreaSampler(light));
    const LightTree tree(same);
    for (std::uint32_t i = 0; i < 100; ++i)
        EXPECT_NEAR(tree.probability(i, point), 0.01, 1e-5);
}

} // namespace
} // namespace scree
