// SPDX-License-Identifier: GPL-3.0-or-later
// Pair correlation and power spectra of point sets with known results.
#include "analysis/nonuniform_fft.h"
#include "analysis/pair_correlation.h"
#include "analysis/plot.h"
#include "analysis/power_spectrum.h"
#include "analysis/report.h"
#include "core/canvas.h"
#include "core/random.h"

#include <gtest/gtest.h>

#include <numeric>

namespace scree {
namespace {

Window rectangle(double width, double depth, bool torus) {
    auto region = std::make_shared<Region>();
    region->rings = {{{0, 0}, {width, 0}, {width, depth}, {0, depth}}};
    return {region, torus};
}

Window round_window(double radius) {
    auto region = std::make_shared<Region>();
    region->rings = {circle_ring({0, 0}, radius, 128)};
    return {region, false};
}

std::vector<Vec2> random_points(const Window& window, std::size_t count, std::uint64_t seed) {
    Random random(seed, Purpose::test);
    const Box2 box = bounds(*window.domain);
    std::vector<Vec2> points;
    while (points.size() < count) {
        const Vec2 p(random.uniform(box.min.x, box.max.x), random.uniform(box.min.y, box.max.y));
        if (contains(*window.domain, p))
            points.push_back(p);
    }
    return points;
}

std::vector<Vec2> square_lattice(int side) {
    std::vector<Vec2> points;
    for (int x = 0; x < side; ++x)
        for (int y = 0; y < side; ++y)
            points.emplace_back((x + 0.25) / side, (y + 0.25) / side);
    return points;
}

TEST(FourierSums, EqualDirectSums) {
    const std::vector<Vec2> points = random_points(rectangle(1, 1, true), 300, 1);
    const FourierSums sums = fourier_sums(points, 13, 40);
    for (int y = 0; y <= 40; ++y)
        for (int x = -13; x <= 13; ++x) {
            std::complex<double> direct = 0;
            for (const Vec2& p : points)
                direct += std::polar(1.0, -2 * pi * (x * p.x + y * p.y));
            EXPECT_LT(std::abs(sums.at(x, y) - direct), 1e-7 * 300) << x << " " << y;
        }
}

// The count in a bin is nearly Poisson, so g has a standard deviation of 1 / sqrt(pairs).
TEST(PairCorrelation, IsOneForPoissonPointsOnAnyWindow) {
    for (const Window& window :
         {rectangle(2, 1, true), rectangle(2, 1, false), round_window(0.8)}) {
        constexpr std::size_t n = 6000;
        constexpr double reach = 0.3;
        const PairCorrelation g = pair_correlation(random_points(window, n, 7), window, reach, 20);
        const double density = double(n) / area(*window.domain);
        for (std::size_t k = 0; k < g.value.size(); ++k) {
            const double ring = pi * (2 * double(k) + 1) * g.bin_width * g.bin_width;
            const double pairs = 0.5 * double(n) * density * ring * 0.75; // 0.75: fewer near edges
            EXPECT_NEAR(g.value[k], 1, 5 / std::sqrt(pairs) + 1e-3) << k; // 1e-3: numerical error
        }
    }
}

TEST(PairCorrelation, OfALatticeHoldsItsShells) {
    // 20 x 20 points on a torus: 4 neighbours at 1 spacing, 4 at sqrt 2, 4 at 2, 8 at sqrt 5.
    const Window window = rectangle(1, 1, true);
    const PairCorrelation g = pair_correlation(square_lattice(20), window, 0.13, 130);
    const auto neighbours_between = [&](double low, double high) {
        double count = 0;
        for (std::size_t k = 0; k < 130; ++k) {
            const double inner = double(k) * 0.001;
            if (inner >= low && inner < high)
                count += g.value[k] * 399 * pi * (2 * inner + 0.001) * 0.001;
        }
        return count;
    };
    EXPECT_NEAR(neighbours_between(0, 0.0485), 0, 1e-9);
    EXPECT_NEAR(neighbours_between(0.0485, 0.0515), 4, 1e-9);
    EXPECT_NEAR(neighbours_between(0.0515, 0.072), 4, 1e-9);
    EXPECT_NEAR(neighbours_between(0.072, 0.11), 4, 1e-9);
    EXPECT_NEAR(neighbours_between(0.11, 0.13), 8, 1e-9);
}

TEST(PairCorrelation, SetCovarianceOfARectangleAndADisk) {
    // A rectangle a x b: a b - 2 r (a + b) / pi + r^2 / pi for r below both sides (Stoyan & Stoyan
    // 1994, p. 123).
    const double r = 0.4;
    EXPECT_NEAR(set_covariance(rectangle(2, 1, false), r), 2 - 2 * r * 3 / pi + r * r / pi, 2e-3);
    EXPECT_DOUBLE_EQ(set_covariance(rectangle(2, 1, true), r), 2);
    const double lens = 2 * std::acos(r / 2) - r / 2 * std::sqrt(4 - r * r);
    EXPECT_NEAR(set_covariance(round_window(1), r), lens, 3e-3);
}

TEST(PairCorrelation, FewPointsHaveNone) {
    const Window window = rectangle(1, 1, false);
    EXPECT_EQ(pair_correlation({}, window, 0.1, 3).value, std::vector<double>(3));
    const std::vector<Vec2> one{{0.5, 0.5}};
    EXPECT_EQ(pair_correlation(one, window, 0.1, 3).value, std::vector<double>(3));
}

// The power of Poisson points at a frequency is exponentially distributed with mean 1.
TEST(PowerSpectrum, OfPoissonPointsIsFlatAndIsotropic) {
    for (const Window& window :
         {rectangle(2, 1, true), rectangle(2, 1, false), round_window(0.8)}) {
        std::vector<PowerSpectrum> spectra;
        constexpr int runs = 10;
        for (std::uint64_t seed = 0; seed < runs; ++seed)
            spectra.push_back(periodogram(random_points(window, 2000, seed), window, 60));
        const RadialSpectrum one = radial_spectrum(spectra[0]);
        const RadialSpectrum ten = radial_spectrum(mean_spectrum(spectra));
        double sum = 0;
        double count = 0;
        for (std::size_t k = 5; k < ten.power.size(); ++k) {
            const double deviation = 1 / std::sqrt(double(ten.count[k]));
            EXPECT_NEAR(one.power[k], 1, 5.5 * deviation) << k; // exponential tails are long
            EXPECT_NEAR(ten.power[k], 1, 5.5 * deviation / std::sqrt(double(runs))) << k;
            sum += ten.anisotropy_db[k] * double(ten.count[k]);
            count += double(ten.count[k]);
        }
        EXPECT_NEAR(sum / count, -10, 0.5); // -10 log10 of ten periodograms
    }
}

TEST(PowerSpectrum, OfALatticeHasItsPeaksAndNothingElse) {
    const PowerSpectrum spectrum = periodogram(square_lattice(16), rectangle(1, 1, true), 40);
    for (int y = 0; y <= 40; ++y)
        for (int x = -40; x <= 40; ++x)
            if (x != 0 || y != 0) {
                EXPECT_NEAR(spectrum.at(x, y), x % 16 == 0 && y % 16 == 0 ? 256 : 0, 1e-3)
                    << x << " " << y;
            }
    EXPECT_EQ(spectrum.at(0, -16), spectrum.at(0, 16));
    const RadialSpectrum radial = radial_spectrum(spectrum);
    EXPECT_GT(radial.power[16], 1);
    EXPECT_GT(radial.anisotropy_db[16], 10); // all its power in two directions
    EXPECT_NEAR(radial.power[8], 0, 1e-6);
}

TEST(PowerSpectrum, OfKindsIsThatOfTheirPointsAlone) {
    PlacedRegions layout;
    layout.window = rectangle(1, 1, true);
    layout.kind_names = {"lattice", "random"};
    layout.positions = square_lattice(16);
    layout.kinds.resize(256, 0);
    for (const Vec2& p : random_points(layout.window, 300, 5)) {
        layout.positions.push_back(p);
        layout.kinds.push_back(1);
    }
    const std::uint64_t seed = 0;
    const AnalysisReport report = analyse(std::span(&layout, 1), std::span(&seed, 1));
    ASSERT_EQ(report.radial_by_kind.size(), 2U);
    const RadialSpectrum& lattice = report.radial_by_kind[0];
    EXPECT_EQ(lattice.bin_width, report.radial.bin_width);
    EXPECT_NEAR(lattice.power[8], 0, 1e-6);
    EXPECT_GT(lattice.power[16], 1);
    const RadialSpectrum& random = report.radial_by_kind[1];
    for (std::size_t k = 5; k < random.power.size(); ++k)
        EXPECT_NEAR(random.power[k], 1, 5.5 / std::sqrt(double(random.count[k]))) << k;
}

TEST(PowerSpectrum, TheWindowIsCorrectedFor) {
    // Without the correction a disk-shaped window of 5000 points has a power of hundreds at the
    // lowest frequencies.
    const Window window = round_window(1);
    const PowerSpectrum spectrum = periodogram(random_points(window, 5000, 4), window, 20);
    for (int y = 0; y <= 2; ++y)
        for (int x = -2; x <= 2; ++x)
            EXPECT_LT(spectrum.at(x, y), 15) << x << " " << y; // exp(-15) = 3e-7
}

TEST(PowerSpectrum, HandlesALargeSetAndNone) {
    const Window window = rectangle(1, 1, true);
    const PowerSpectrum large = periodogram(random_points(window, 100000, 2), window, 900);
    EXPECT_EQ(large.reach_x, 900);
    double sum = std::accumulate(large.power.begin(), large.power.end(), 0.0);
    EXPECT_NEAR(sum / double(large.power.size()), 1, 0.01);
    const PowerSpectrum none = periodogram({}, window, 5);
    EXPECT_EQ(none.power, std::vector<double>(none.power.size()));
}

TEST(Plot, TicksAreRound) {
    EXPECT_EQ(ticks({0, 6, ""}), (std::vector<double>{0, 1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(ticks({-15, 15, ""}, 5), (std::vector<double>{-15, -10, -5, 0, 5, 10, 15}));
    EXPECT_TRUE(ticks({1, 1, ""}).empty());
}

TEST(Canvas, CoversExactAreas) {
    Canvas canvas(20, 20, Color(0, 0, 0));
    const auto light = [&] {
        double sum = 0;
        for (std::size_t i = 0; i < canvas.image().pixels.size(); i += 3)
            sum += double(canvas.image().pixels[i]);
        return sum;
    };
    const std::vector<Ring> holed{circle_ring({10.3, 9.6}, 7.2, 200),
                                  circle_ring({10, 10}, 2.5, 50)};
    std::vector<Ring> rings = holed;
    std::reverse(rings[1].begin(), rings[1].end());
    canvas.fill(rings, Color(1, 1, 1));
    EXPECT_NEAR(light(), signed_area(holed[0]) - signed_area(holed[1]), 1e-3);
    // Half outside the picture, and clipped.
    canvas = Canvas(20, 20, Color(0, 0, 0));
    const std::vector<Ring> large{{{-10, -5}, {30, -5}, {30, 5.5}, {-10, 5.5}}};
    canvas.clip({{5, 0}, {9, 20}});
    canvas.fill(large, Color(1, 1, 1));
    EXPECT_NEAR(light(), 4 * 5.5, 1e-4);
}

TEST(Canvas, TextIsDrawnAndRotated) {
    Canvas canvas(80, 80, Color(1, 1, 1));
    canvas.text({40, 40}, "Scree", 20, Color(0, 0, 0), Align::centre);
    double dark = 0;
    double left = 0;
    for (int y = 0; y < 80; ++y)
        for (int x = 0; x < 80; ++x) {
            const double ink = 1 - double(*canvas.image().at(x, y));
            dark += ink;
            left += x < 40 ? ink : 0;
            if (ink > 0.5) {
                EXPECT_GT(y, 18);
                EXPECT_LT(y, 44);
            }
        }
    EXPECT_GT(dark, 50);
    EXPECT_NEAR(left / dark, 0.5, 0.15);
    Canvas turned(80, 80, Color(1, 1, 1));
    turned.text({40, 40}, "Scree", 20, Color(0, 0, 0), Align::centre, true);
    double turned_dark = 0;
    for (const float value : turned.image().pixels)
        turned_dark += 1 - double(value);
    EXPECT_NEAR(turned_dark / 3, dark, 1e-3);
}

} // namespace
} // namespace scree
