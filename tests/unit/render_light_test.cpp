// SPDX-License-Identifier: GPL-3.0-or-later
// How lights are sampled, against their own densities.
#include "render/light/light_sampler.h"
#include "tests/support/sampled_directions.h"

#include <gtest/gtest.h>

namespace scree {
namespace {

using test::check_directions;
using test::next_pair;
using test::sample_count;

Sky image_sky() {
    Sky sky;
    auto image = std::make_shared<Image>(12, 6, std::vector<std::string>{"R", "G", "B"});
    Random random(2, Purpose::test);
    for (float& v : image->pixels)
        v = 0.1F + random.uniform_float();
    image->at(7, 2)[1] = 6;
    sky.image = image;
    sky.rotation = 1;
    return sky;
}

// Axes are turned so that the poles of the cells are those of the sky, where its density is odd.
Vec3 cells_from_sky(const Vec3& d) { return {d.x, d.z, d.y}; }

TEST(Sampling, Skies) {
    Sky gradient;
    gradient.horizon = {4.0F, 4.0F, 4.0F};
    gradient.ground = {0.2F, 0.2F, 0.2F};
    for (const Sky& sky : {image_sky(), gradient, Sky{}})
        for (const bool compensate : {false, true}) {
            const SkySampler sampler(sky, compensate);
            if (sampler.irradiance() == 0) {
                EXPECT_EQ(sampler.pdf(Vec3(0.0F, 1.0F, 0.0F)), 0);
                continue;
            }
            int differences = 0; // at the edges of cells, by rounding
            EXPECT_EQ(check_directions(
                          [&](Random& random) {
                              float pdf = 0;
                              const Vec3 d = sampler.sample(next_pair(random), pdf);
                              differences += std::abs(pdf / sampler.pdf(d) - 1) > 1e-3F ? 1 : 0;
                              return cells_from_sky(d);
                          },
                          [&](const Vec3& d) { return sampler.pdf(cells_from_sky(d)); }, 96),
                      "");
        }
}

TEST(Sampling, SunAndItsIrradiance) {
    const Sun sun{Vec3(0.3F, 1.0F, -0.2F), 1.2F, Color(1.0F, 1.0F, 1.0F), 3.0F};
    const SunSampler sampler(sun);
    const Vec3 axis = sun.direction.normalized();
    const Frame frame(axis);
    Random random(4, Purpose::test);
    std::vector<double> observed(16 * 16);
    double irradiance = 0;
    for (int i = 0; i < sample_count; ++i) {
        const Vec3 d = sampler.sample(next_pair(random));
        ASSERT_GT(sampler.pdf(d), 0) << "outside of its own cone";
        irradiance += double(sampler.radiance(d).x * d.dot(axis) / sampler.pdf(d)) / sample_count;
        const double part = (1 - double(d.dot(axis))) / (1 - std::cos(0.6));
        const double turn = std::atan2(double(d.dot(frame.y)), double(d.dot(frame.x)));
        const int ring = std::clamp(static_cast<int>(part * 16), 0, 15);
        const int sector = std::clamp(static_cast<int>((turn / (2 * pi) + 0.5) * 16), 0, 15);
        observed[std::size_t(ring * 16 + sector)] += 1;
    }
    EXPECT_EQ(test::chi_square(observed, std::vector<double>(256, sample_count / 256.0),
                               test::sampling_alpha),
              "");
    EXPECT_NEAR(irradiance, 3, 0.01);
    EXPECT_NEAR(sampler.pdf(axis) * 2 * pi * (1 - std::cos(0.6)), 1, 1e-5);
}

TEST(Sampling, AreaLight) {
    AreaLight light;
    light.centre = {0.2F, -0.3F, 1.0F};
    light.edge_u = {0.0F, 1.5F, 0.0F};
    light.edge_v = {1.0F, 0.0F, 0.0F};
    const AreaSampler sampler(light);
    const Vec3 normal = light.normal();
    EXPECT_LT(normal.z, 0);
    EXPECT_EQ(check_directions(
                  [&](Random& random) {
                      return sampler.sample(Vec3(0.0F, 0.0F, 0.0F), next_pair(random)).direction;
                  },
                  [&](const Vec3& d) {
                      if (d.z <= 0)
                          return 0.0F;
                      const float distance = 1 / d.z;
                      const Vec3 p = d * distance - light.centre;
                      const bool inside = std::abs(p.x) < 0.5F && std::abs(p.y) < 0.75F;
                      return inside ? sampler.pdf(d, distance) : 0.0F;
                  },
                  96),
              "");
}

TEST(Sampling, ChoiceOfLightsSumsToOne) {
    const std::vector<Light> lights = {
        test::even_sky(1), Sun{Vec3(0.0F, 1.0F, 0.0F), 0.5F, Color(1.0F, 1.0F, 1.0F), 2.0F}};
    const LightSampler sampler(lights, false);
    EXPECT_EQ(
        check_directions(
            [&](Random& random) {
                const float choice = random.uniform_float();
                const Vec3 point(0.0F, 0.0F, 0.0F);
                return cells_from_sky(sampler.sample(point, choice, next_pair(random)).direction);
            },
            [&](const Vec3& d) {
                float sum = 0;
                sampler.at_infinity(Vec3(0.0F, 0.0F, 0.0F), cells_from_sky(d),
                                    [&](const Color&, float pdf, std::uint32_t) { sum += pdf; });
                return sum;
            },
            96),
        "");
}

} // namespace
} // namespace scree
