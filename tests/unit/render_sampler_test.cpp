// SPDX-License-Identifier: GPL-3.0-or-later
// The sampler's stratification, filters, the lens and tabulated densities.
#include "core/distribution.h"
#include "core/warps.h"
#include "render/film/filter.h"
#include "render/sampler.h"
#include "tests/support/sampled_directions.h"

#include <gtest/gtest.h>

namespace scree {
namespace {

using test::next_pair;
using test::sample_count;

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
        EXPECT_EQ(test::chi_square(observed, expected, test::sampling_alpha), "");
    }
    Random random(7, Purpose::test);
    std::vector<double> disk(std::size_t{16} * 16);
    for (int i = 0; i < sample_count; ++i) {
        const Vec2f d = warp::disk(next_pair(random));
        const int ring = std::clamp(static_cast<int>(d.dot(d) * 16), 0, 15);
        const double turn = std::atan2(double(d.y), double(d.x)) / (2 * pi) + 0.5;
        const int sector = std::clamp(static_cast<int>(turn * 16), 0, 15);
        disk[std::size_t(ring) * 16 + std::size_t(sector)] += 1;
    }
    EXPECT_EQ(test::chi_square(disk, std::vector<double>(256, sample_count / 256.0),
                               test::sampling_alpha),
              "");
}

TEST(Sobol, TheFirstPairIsThatOfTheMatrices) {
    Random random(8, Purpose::test);
    for (int i = 0; i < 1000; ++i) {
        const std::uint32_t index = random.below(0xffffffffU);
        ASSERT_EQ(sobol::first_pair(index), sobol::pair(index, 0)) << index;
    }
}

// Matrices of full rank in every leading square: each coordinate alone is stratified.
TEST(Sobol, EveryCoordinateIsStratified) {
    for (std::size_t d = 0; d < sobol::dimensions; d += 2)
        for (int m = 0; m <= 10; ++m) {
            std::array<std::vector<int>, 2> cells{std::vector<int>(std::size_t{1} << m),
                                                  std::vector<int>(std::size_t{1} << m)};
            for (std::uint32_t i = 0; i < 1U << m; ++i) {
                const auto p = sobol::pair(i, d);
                for (std::size_t k = 0; k < 2; ++k)
                    ++cells[k][static_cast<std::size_t>(sobol::to_unit(p[k]) *
                                                        static_cast<float>(1 << m))];
            }
            for (const std::vector<int>& count : cells)
                ASSERT_EQ(*std::max_element(count.begin(), count.end()), 1) << d << " " << m;
        }
}

// The variance of the mean of prod (1 + cos(2 pi x)) over 64 samples, for the film, the first
// direction and the first light together: of independent samples it is (1.5^6 - 1) / 64.
TEST(Sampler, FilmDirectionAndLightAreStratifiedTogether) {
    constexpr int pixels = 4000;
    constexpr std::uint32_t samples = 64;
    const std::array<std::uint32_t, 3> joint{dimension::film,
                                             dimension::at(0, dimension::direction),
                                             dimension::at(0, dimension::light)};
    const std::array<std::uint32_t, 3> apart{dimension::lens, dimension::at(0, dimension::choice),
                                             dimension::at(0, dimension::roulette)};
    const auto variance = [&](const std::array<std::uint32_t, 3>& pairs, double& mean) {
        double sum = 0, squares = 0;
        for (int pixel = 0; pixel < pixels; ++pixel) {
            double total = 0;
            for (std::uint32_t i = 0; i < samples; ++i) {
                double product = 1;
                for (const std::uint32_t pair : pairs) {
                    const Vec2f p = Sampler(4, pixel, 2, i).pair(pair);
                    product *=
                        (1 + std::cos(2 * pi * double(p.x))) * (1 + std::cos(2 * pi * double(p.y)));
                }
                total += product / samples;
            }
            sum += total / pixels;
            squares += (total - 1) * (total - 1) / pixels;
        }
        mean = sum;
        return squares;
    };
    double mean_joint = 0, mean_apart = 0;
    const double together = variance(joint, mean_joint);
    const double each = variance(apart, mean_apart);
    EXPECT_NEAR(mean_joint, 1, 5 * std::sqrt(together / pixels));
    EXPECT_NEAR(mean_apart, 1, 5 * std::sqrt(each / pixels));
    EXPECT_LT(together, 0.8 * each);
}

TEST(Sampler, EveryPrefixIsAnElementaryNet) {
    for (const std::uint32_t dimension :
         {dimension::film, dimension::lens, dimension::at(1, dimension::choice),
          dimension::at(0, dimension::choice)})
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
