// SPDX-License-Identifier: GPL-3.0-or-later
// The estimate of a picture's error against the error itself.
#include "core/random.h"
#include "render/film/error_estimate.h"
#include "render/sampler.h"
#include "tests/support/rendering.h"

#include <gtest/gtest.h>

namespace scree {
namespace {

constexpr int side = 64;
constexpr double mid_grey = 0.18;

PathSample grey_sample(float value) {
    PathSample sample;
    sample.radiance = {value, value, value};
    return sample;
}

double measured_error(const Film& film, double truth) {
    double sum = 0;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            sum += std::pow((film.luminance_at(x, y) - truth) / (truth + mid_grey), 2);
    return std::sqrt(sum / (side * side));
}

ErrorEstimate estimate_of(const Film& film) {
    ErrorEstimate estimate;
    estimate.add(film, 0, 0, film.width(), film.height());
    return estimate;
}

// 4096 pixels: both errors are known to about 1/sqrt(2 * 4096) = 1.1%.
TEST(ErrorEstimate, IndependentSamples) {
    for (const int samples : {2, 5, 16, 40, 64}) {
        Film film(side, side);
        Random random(1, Purpose::test);
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                for (int i = 0; i < samples; ++i)
                    film.add(x, y, grey_sample(random.uniform_float()), 0);
        const double expected = std::sqrt(1 / 12.0 / samples) / (0.5 + mid_grey);
        EXPECT_NEAR(measured_error(film, 0.5), expected, 0.05 * expected);
        EXPECT_NEAR(estimate_of(film).independent(), expected, 0.06 * expected) << samples;
        if (samples >= 16) { // of fewer, halves of halves say little
            EXPECT_NEAR(estimate_of(film).value(), expected, 0.12 * expected) << samples;
        }
    }
}

// Samples of the renderer's sequence: light of a half-hidden source, times that of the next bounce.
TEST(ErrorEstimate, StratifiedSamples) {
    constexpr double truth = 0.5 * 1.5;
    for (const int samples : {64, 128, 256}) {
        Film film(side, side);
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                for (int i = 0; i < samples; ++i) {
                    const Sampler sampler(1, x, y, std::uint32_t(i));
                    const Vec2f film_place = sampler.pair(dimension::film);
                    const Vec2f light = sampler.pair(dimension::at(0, dimension::light));
                    const Vec2f next = sampler.pair(dimension::at(1, dimension::direction));
                    const bool seen = film_place.x + light.x + light.y < 1.5F;
                    film.add(x, y, grey_sample(seen ? 0.5F + 2 * next.x : 0.0F), 0);
                }
        const double measured = measured_error(film, truth);
        const ErrorEstimate estimate = estimate_of(film);
        EXPECT_GT(estimate.independent(), 1.2 * measured) << samples;
        EXPECT_NEAR(estimate.value(), measured, 0.2 * measured) << samples;
    }
}

TEST(ErrorEstimate, IsInfiniteWhereNothingIsKnown) {
    Film film(2, 1);
    EXPECT_EQ(ErrorEstimate().value(), INFINITY);
    EXPECT_EQ(estimate_of(film).value(), INFINITY);
    film.add(0, 0, grey_sample(1), 0);
    film.add(0, 0, grey_sample(1), 0);
    film.add(1, 0, grey_sample(1), 0);
    EXPECT_EQ(estimate_of(film).value(), INFINITY);
    film.add(1, 0, grey_sample(1), 0);
    EXPECT_EQ(estimate_of(film).value(), 0);
}

// A ball's soft shadow under a lamp and a sky, rendered to a limit of noise.
TEST(ErrorEstimate, OfAPictureWithALimitOfNoise) {
    test::Stage stage;
    stage.film.width = stage.film.height = side;
    stage.film.samples = 4096;
    stage.film.depth = 5;
    stage.camera.from = {0.0F, 1.0F, 3.0F};
    stage.camera.fov = 0.7F;
    stage.lights.push_back(test::even_sky(0.2F));
    AreaLight lamp;
    lamp.centre = {1, 2, 0};
    lamp.radiance = {4.0F, 4.0F, 4.0F};
    stage.lights.push_back(lamp);
    stage.add(test::make_sphere(0.6F, 24, false), test::grey_matte(0.6F));
    stage.add(test::make_plane(4), test::grey_matte(0.6F), test::move(Vec3(0.0F, -0.6F, 0.0F)));
    const Film reference = stage.render().film;
    RenderOptions options;
    options.seed = 1;
    options.noise = 0.02;
    const RenderResult result = stage.render(options);
    EXPECT_LT(result.stats.samples_per_pixel, 1000);
    double sum = 0;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const double truth = reference.luminance_at(x, y);
            sum += std::pow((result.film.luminance_at(x, y) - truth) / (truth + mid_grey), 2);
        }
    const double measured = std::sqrt(sum / (side * side));
    EXPECT_NEAR(result.stats.error, measured, 0.2 * measured);
    EXPECT_LT(measured, 1.2 * options.noise);
}

} // namespace
} // namespace scree
