// SPDX-License-Identifier: GPL-3.0-or-later
// Every sampling routine against its own density, by chi-square; and the sampler's stratification.
#include "core/random.h"
#include "core/warps.h"
#include "render/bsdf/ggx.h"
#include "render/film/filter.h"
#include "render/sampler.h"
#include "tests/support/rendering.h"

#include "core/distribution.h"
#include <algorithm>

#include <gtest/gtest.h>

namespace scree {
namespace {

// About 40 tests share this chance of a false alarm in the whole file: 0.001; seeds are fixed.
constexpr double alpha = 0.001 / 40;
constexpr int sample_count = 200'000;
constexpr int rows = 16;
constexpr int columns = 32;

Vec2f next_pair(Random& random) {
    const float x = random.uniform_float();
    return {x, random.uniform_float()};
}

// `sample` answers a direction, or zero for a lost sample, whose share is whatever the density
// leaves below 1. Cells are of equal solid angle.
std::string check_directions(const std::function<Vec3(Random&)>& sample,
                             const std::function<float(const Vec3&)>& pdf, int fine = 24) {
    std::vector<double> observed(rows * columns + 1);
    std::vector<double> expected(rows * columns + 1);
    Random random(11, Purpose::test);
    for (int i = 0; i < sample_count; ++i) {
        const Vec3 d = sample(random);
        if (d.length() == 0) {
            observed.back() += 1;
            continue;
        }
        if (std::abs(d.length() - 1) > 1e-4F)
            return "a direction is not of unit length";
        const int row = std::clamp(static_cast<int>((d.z + 1) / 2 * rows), 0, rows - 1);
        const double turn = std::atan2(double(d.y), double(d.x)) / (2 * pi) + 0.5;
        const int column = std::clamp(static_cast<int>(turn * columns), 0, columns - 1);
        observed[std::size_t(row * columns + column)] += 1;
    }
    double total = 0;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            double sum = 0;
            for (int i = 0; i < fine; ++i)
                for (int j = 0; j < fine; ++j) {
                    const double z = (row + (i + 0.5) / fine) / rows * 2 - 1;
                    const double turn = ((column + (j + 0.5) / fine) / columns - 0.5) * 2 * pi;
                    const double sine = std::sqrt(1 - z * z);
                    sum += double(pdf(Vec3(static_cast<float>(sine * std::cos(turn)),
                                           static_cast<float>(sine * std::sin(turn)),
                                           static_cast<float>(z))));
                }
            const double share = sum / (fine * fine) * 4 * pi / (rows * columns);
            expected[std::size_t(row * columns + column)] = share * sample_count;
            total += share;
        }
    if (total > 1.004)
        return "the density integrates to " + std::to_string(total);
    expected.back() = std::max(0.0, 1 - total) * sample_count;
    return test::chi_square(observed, expected, alpha);
}

const Vec3 views[] = {Vec3(0.0F, 0.0F, 1.0F), Vec3(0.6F, 0.0F, 0.8F),
                      Vec3(-0.5F, 0.8F, 0.331662479F)};

void check_bsdf(const Bsdf& bsdf, int fine = 24) {
    for (const Vec3& wo : views)
        EXPECT_EQ(check_directions(
                      [&](Random& random) {
                          const float choice = random.uniform_float();
                          const BsdfSample s = bsdf.sample(wo, choice, next_pair(random));
                          return s.pdf > 0 && !s.delta ? s.direction : Vec3(0.0F, 0.0F, 0.0F);
                      },
                      [&](const Vec3& wi) { return bsdf.evaluate(wo, wi).pdf; }, fine),
                  "")
            << "wo.z = " << wo.z;
}

// Sampling weights, too, must be the value over the density.
void check_weights(const Bsdf& bsdf) {
    Random random(5, Purpose::test);
    for (const Vec3& wo : views)
        for (int i = 0; i < 2000; ++i) {
            const float choice = random.uniform_float();
            const BsdfSample s = bsdf.sample(wo, choice, next_pair(random));
            if (!(s.pdf > 0) || s.delta)
                continue;
            const BsdfValue v = bsdf.evaluate(wo, s.direction);
            ASSERT_NEAR(s.pdf / v.pdf, 1, 1e-2);
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(s.weight[c], v.value[c] / v.pdf, 1e-3F + 1e-2F * s.weight[c]);
        }
}

double albedo(const Bsdf& bsdf, const Vec3& wo) {
    double sum = 0;
    for (std::uint32_t i = 0; i < 1U << 16; ++i) {
        const Sampler sampler(3, 0, 0, i);
        const BsdfSample s = bsdf.sample(wo, sampler.pair(0).x, sampler.pair(1));
        if (s.pdf > 0)
            sum += double(s.weight.y);
    }
    return sum / (1U << 16);
}

Bsdf make(BsdfKind kind, float a, float eta, const Albedo& table) {
    Bsdf bsdf;
    bsdf.kind = kind;
    bsdf.color = {1.0F, 1.0F, 1.0F};
    bsdf.alpha = a;
    bsdf.eta = eta;
    bsdf.albedo = table;
    return bsdf;
}

// One place of a surface whose roughness goes by place.
Bsdf make_varied(BsdfKind kind, float roughness, float eta, const RoughnessTables& tables) {
    return make(kind, ggx::alpha(roughness), eta, tables.at(roughness));
}

TEST(Sampling, Matte) {
    check_bsdf(make(BsdfKind::matte, 0, 1, nullptr));
    check_weights(make(BsdfKind::matte, 0, 1, nullptr));
}

TEST(Sampling, Metal) {
    for (const float a : {0.2F, 0.8F}) {
        const AlbedoTable table(a, 0);
        check_bsdf(make(BsdfKind::metal, a, 1, &table));
        check_weights(make(BsdfKind::metal, a, 1, &table));
    }
}

TEST(Sampling, Plastic) {
    for (const float a : {0.2F, 0.6F}) {
        const AlbedoTable table(a, 1.5F);
        check_bsdf(make(BsdfKind::plastic, a, 1.5F, &table));
        check_weights(make(BsdfKind::plastic, a, 1.5F, &table));
    }
}

TEST(Sampling, TranslucentOnTheWayInAndOut) {
    for (const float a : {0.2F, 0.6F}) {
        const AlbedoTable table(a, 1.5F);
        for (const BsdfKind kind : {BsdfKind::translucent, BsdfKind::emerging}) {
            check_bsdf(make(kind, a, 1.5F, &table));
            check_weights(make(kind, a, 1.5F, &table));
        }
        for (const Vec3& wo : views) {
            EXPECT_NEAR(albedo(make(BsdfKind::translucent, a, 1.5F, &table), wo), 1, 0.01);
            EXPECT_NEAR(albedo(make(BsdfKind::emerging, a, 1.5F, &table), wo), 1, 0.001);
        }
    }
}

// Roughnesses between the tables; the sharpest is as narrow as the cells can tell.
TEST(Sampling, VariedRoughness) {
    const RoughnessTables mirror(0);
    const RoughnessTables coat(1.5F);
    for (const float roughness : {0.42F, 0.64F, 0.9F}) {
        const Bsdf metal = make_varied(BsdfKind::metal, roughness, 1, mirror);
        const Bsdf plastic = make_varied(BsdfKind::plastic, roughness, 1.5F, coat);
        for (const Bsdf& bsdf : {metal, plastic}) {
            check_bsdf(bsdf);
            check_weights(bsdf);
        }
    }
}

TEST(Sampling, VariedRoughnessKeepsTheAlbedo) {
    const RoughnessTables mirror(0);
    const RoughnessTables coat(1.5F);
    for (const float roughness : {0.0F, 0.02F, 0.11F, 0.172F, 0.3F, 0.484F, 0.703F, 0.95F, 1.0F})
        for (const float cosine : {0.05F, 0.3F, 0.7F, 1.0F}) {
            const Vec3 wo(std::sqrt(1 - cosine * cosine), 0.0F, cosine);
            const Bsdf metal = make_varied(BsdfKind::metal, roughness, 1, mirror);
            EXPECT_NEAR(albedo(metal, wo), 1, 0.005) << roughness << " " << cosine;
            const Bsdf plastic = make_varied(BsdfKind::plastic, roughness, 1.5F, coat);
            EXPECT_NEAR(albedo(plastic, wo), 1, 0.01) << roughness << " " << cosine;
        }
}

TEST(Sampling, RoughGlassFromBothSides) {
    for (const float eta : {1.5F, 1 / 1.5F}) {
        check_bsdf(make(BsdfKind::rough_glass, 0.6F, eta, nullptr), 64);
        check_weights(make(BsdfKind::rough_glass, 0.6F, eta, nullptr));
    }
}

TEST(Sampling, VisibleNormals) {
    for (const Vec3& wo : views)
        EXPECT_EQ(
            check_directions(
                [&](Random& random) {
                    return ggx::sample_visible_normal(wo, 0.4F, next_pair(random));
                },
                [&](const Vec3& m) { return m.z > 0 ? ggx::visible_density(wo, m, 0.4F) : 0.0F; }),
            "");
}

TEST(Sampling, AlbedoIsOneForWhiteAndNeverMore) {
    for (const float a : {1e-3F, 0.04F, 0.25F, 1.0F})
        for (const float cosine : {0.05F, 0.3F, 0.7F, 1.0F}) {
            const Vec3 wo(std::sqrt(1 - cosine * cosine), 0.0F, cosine);
            const AlbedoTable mirror(a, 0);
            const AlbedoTable coat(a, 1.5F);
            EXPECT_NEAR(albedo(make(BsdfKind::metal, a, 1, &mirror), wo), 1, 0.005) << a;
            EXPECT_NEAR(albedo(make(BsdfKind::plastic, a, 1.5F, &coat), wo), 1, 0.01) << a;
            const double rough = albedo(make(BsdfKind::rough_glass, a, 1.5F, nullptr), wo);
            EXPECT_LE(rough, 1.001);
            EXPECT_GE(rough, a < 0.3F ? 0.9 : 0.5);
        }
}

TEST(Sampling, PlasticIsReciprocal) {
    const AlbedoTable table(0.3F, 1.5F);
    const Bsdf bsdf = make(BsdfKind::plastic, 0.3F, 1.5F, &table);
    const float there = bsdf.evaluate(views[1], views[2]).value.x / views[2].z;
    const float back = bsdf.evaluate(views[2], views[1]).value.x / views[1].z;
    EXPECT_NEAR(there, back, 1e-5F);
}

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
    EXPECT_EQ(test::chi_square(observed, std::vector<double>(256, sample_count / 256.0), alpha),
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

TEST(Sampling, FiltersAndLens) {
    for (const auto& [filter, radius] :
         {std::pair{Filter::box, 0.5F}, std::pair{Filter::triangle, 1.0F},
          std::pair{Filter::gaussian, 1.5F}, std::pair{Filter::blackman_harris, 1.5F}}) {
        const FilterSampler sampler(filter, radius);
        constexpr int cells = 64;
        std::vector<double> observed(cells);
        std::vector<double> expected(cells);
        Random random(6, Purpose::test);
        for (int i = 0; i < sample_count; ++i) {
            const float x = sampler.offset(next_pair(random)).x;
            observed[std::size_t(
                std::clamp(static_cast<int>((x / radius + 1) / 2 * cells), 0, cells - 1))] += 1;
        }
        double total = 0;
        for (int i = 0; i < cells * 32; ++i) {
            const float x = ((static_cast<float>(i) + 0.5F) / (cells * 16) - 1) * radius;
            expected[std::size_t(i / 32)] += double(filter_value(filter, radius, x));
            total += double(filter_value(filter, radius, x));
        }
        for (double& e : expected)
            e *= sample_count / total;
        EXPECT_EQ(test::chi_square(observed, expected, alpha), "");
    }
    Random random(7, Purpose::test);
    std::vector<double> disk(16 * 16);
    for (int i = 0; i < sample_count; ++i) {
        const Vec2f d = warp::disk(next_pair(random));
        const int ring = std::clamp(static_cast<int>(d.dot(d) * 16), 0, 15);
        const double turn = std::atan2(double(d.y), double(d.x)) / (2 * pi) + 0.5;
        disk[std::size_t(ring * 16 + std::clamp(static_cast<int>(turn * 16), 0, 15))] += 1;
    }
    EXPECT_EQ(test::chi_square(disk, std::vector<double>(256, sample_count / 256.0), alpha), "");
}

TEST(Sampling, ChoiceOfLightsSumsToOne) {
    const std::vector<Light> lights = {
        test::even_sky(1), Sun{Vec3(0.0F, 1.0F, 0.0F), 0.5F, Color(1.0F, 1.0F, 1.0F), 2.0F}};
    const LightSampler sampler(lights, false);
    EXPECT_EQ(check_directions(
                  [&](Random& random) {
                      const float choice = random.uniform_float();
                      const Vec3 point(0.0F, 0.0F, 0.0F);
                      return cells_from_sky(
                          sampler.sample(point, choice, next_pair(random)).direction);
                  },
                  [&](const Vec3& d) {
                      float sum = 0;
                      sampler.at_infinity(Vec3(0.0F, 0.0F, 0.0F), cells_from_sky(d),
                                          [&](const Color&, float pdf) { sum += pdf; });
                      return sum;
                  },
                  96),
              "");
}

TEST(Sampler, EveryPrefixIsAnElementaryNet) {
    for (const std::uint32_t dimension : {0U, 1U, 7U})
        for (int m = 0; m <= 10; ++m)
            for (int x_bits = 0; x_bits <= m; ++x_bits) {
                const int y_bits = m - x_bits;
                std::vector<int> cells(std::size_t{1} << m);
                for (std::uint32_t i = 0; i < 1U << m; ++i) {
                    const Vec2f p = Sampler(9, 31, 17, i).pair(dimension);
                    const auto x = static_cast<std::size_t>(p.x * static_cast<float>(1 << x_bits));
                    const auto y = static_cast<std::size_t>(p.y * static_cast<float>(1 << y_bits));
                    ++cells[(y << x_bits) + x];
                }
                ASSERT_EQ(*std::max_element(cells.begin(), cells.end()), 1) << m << " " << x_bits;
            }
}

TEST(Sampler, PixelsAndDimensionsAreIndependent) {
    // Correlation of 4096 neighbours, for sample 0 and across dimensions: 0 within 5 deviations.
    const auto correlation = [](const std::function<float(int)>& a,
                                const std::function<float(int)>& b) {
        double sum = 0;
        for (int i = 0; i < 4096; ++i)
            sum += (double(a(i)) - 0.5) * (double(b(i)) - 0.5);
        return sum * 12 / std::sqrt(4096.0);
    };
    const auto at = [](int x, int y, std::uint32_t dimension) {
        return Sampler(1, x, y, 0).pair(dimension);
    };
    for (const auto& b : std::vector<std::function<float(int)>>{
             [&](int i) { return at(i + 1, 0, 0).x; }, [&](int i) { return at(i, 1, 0).x; },
             [&](int i) { return at(i, 0, 1).x; }, [&](int i) { return at(i, 0, 0).y; }})
        EXPECT_LT(std::abs(correlation([&](int i) { return at(i, 0, 0).x; }, b)), 5);
}

// A sample at the very end of a cell must not land in an empty neighbour by rounding.
TEST(Sampling, DistributionStaysOutOfEmptyCells) {
    for (const int height : {3, 7, 64, 100, 1000}) {
        std::vector<float> weights(std::size_t(height) * 2, 0.0F);
        for (int y = 0; y + 1 < height; y += 2)
            weights[2 * std::size_t(y)] = 1;
        const Distribution2D distribution(weights, 2, height);
        const int full = height / 2;
        for (int edge = 1; edge <= full; ++edge) {
            float u = static_cast<float>(edge) / static_cast<float>(full);
            for (int step = 0; step < 50; ++step) {
                u = std::nextafter(u, 0.0F);
                float pdf = 0;
                const Vec2f p = distribution.sample({u, u}, pdf);
                ASSERT_GT(pdf, 0) << height << " " << u;
                ASSERT_EQ(distribution.pdf(p), pdf) << height << " " << u;
            }
        }
    }
}

} // namespace
} // namespace scree
