// SPDX-License-Identifier: GPL-3.0-or-later
// The denoiser on films with known noise, and on a rendered picture.
#include "core/parallel.h"
#include "render/film/denoise.h"
#include "tests/support/rendering.h"

#include <gtest/gtest.h>

namespace scree {
namespace {

using test::Stage;

/// What a pixel truly is. The samples' radiance is spread evenly over (1 - noise, 1 + noise) times
/// it.
struct Truth {
    float radiance = 0.5F;
    float albedo = 0.5F;
    Vec3 normal{0.0F, 0.0F, 1.0F};
    float noise = 0.7F;
    bool covered = true;
};
using Scene2D = std::function<Truth(int x, int y)>;

void add_samples(Film& film, int x, int y, const Truth& truth, int samples, Random& random) {
    for (int s = 0; s < samples; ++s) {
        PathSample sample;
        sample.radiance =
            Color(truth.radiance * (1 + truth.noise * static_cast<float>(random.uniform(-1, 1))));
        sample.albedo = Color(truth.albedo);
        sample.normal = truth.normal;
        sample.covered = truth.covered;
        film.add(x, y, sample, 1);
    }
}

/// `shift_x`, `shift_y`: what of the plane the film's first pixel is.
Film film_of(int width, int height, int samples, const Scene2D& scene, int shift_x = 0,
             int shift_y = 0) {
    Film film(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const int px = x + shift_x;
            const int py = y + shift_y;
            Random random(7, Purpose::test, std::uint64_t(py * 1000 + px));
            add_samples(film, x, y, scene(px, py), samples, random);
        }
    return film;
}

double root_mean_square_error(const Image& picture, const Scene2D& scene) {
    double sum = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            for (int c = 0; c < 3; ++c)
                sum += std::pow(double(picture.at(x, y)[c]) - double(scene(x, y).radiance), 2);
    return std::sqrt(sum / (3.0 * picture.width * picture.height));
}

double mean_of(const Image& picture, int x0, int x1) {
    double sum = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = x0; x < x1; ++x)
            sum += double(picture.at(x, y)[1]);
    return sum / (double(x1 - x0) * picture.height);
}

bool finite(const Image& picture) {
    return std::ranges::all_of(picture.pixels,
                               [](float value) { return std::isfinite(value) && value >= 0; });
}

TEST(FilmHalves, AreTheFirstPowerOfTwoOfSamplesAndTheRest) {
    for (const auto& [samples, first] : {std::pair{1, 0}, {2, 1}, {3, 2}, {16, 8}, {17, 16}}) {
        Film film(1, 1);
        for (int s = 0; s < samples; ++s) {
            PathSample sample;
            sample.radiance = Color(static_cast<float>(s));
            sample.albedo = Color(static_cast<float>(s) / 32);
            sample.normal = Vec3(0.0F, static_cast<float>(s), 0.0F);
            sample.covered = true;
            film.add(0, 0, sample, 1);
        }
        const Film::Halves halves = film.halves(0, 0);
        const auto expect_means = [](const Film::Means& means, int from, int to) {
            const float mean = to > from ? static_cast<float>(from + to - 1) / 2 : 0;
            EXPECT_EQ(means.samples, std::uint32_t(to - from));
            EXPECT_NEAR(means.radiance[1], mean, 1e-5F);
            EXPECT_NEAR(means.albedo[2], mean / 32, 1e-6F);
            EXPECT_NEAR(means.normal.y, mean, 1e-5F);
        };
        expect_means(halves.all, 0, samples);
        expect_means(halves.first, 0, first);
        expect_means(halves.rest, first, samples);
    }
}

// The mean of 16 samples has a deviation of 0.7 / sqrt(3) / 4 = 10%.
TEST(Denoise, BringsAConstantPictureNearItsMean) {
    const Scene2D scene = [](int, int) { return Truth{}; };
    const Film film = film_of(96, 64, 16, scene);
    const Image picture = denoise(film);
    const double deviation = 0.5 * 0.7 / std::sqrt(3.0) / 4;
    EXPECT_LT(root_mean_square_error(picture, scene), deviation / 4)
        << "as if fewer than 16 pixels were averaged";
    EXPECT_NEAR(mean_of(picture, 0, 96), 0.5, 4 * deviation / std::sqrt(96.0 * 64.0));
}

struct Edge {
    const char* name;
    Truth left;
    Truth right;
};

class DenoisedEdge : public testing::TestWithParam<Edge> {};

// The columns beside the edge: their mean has a deviation of 10% / sqrt(64) = 1.3% of the side's
// radiance in the raw picture.
TEST_P(DenoisedEdge, KeepsItsContrast) {
    const Edge& edge = GetParam();
    const Scene2D scene = [&](int x, int) { return x < 33 ? edge.left : edge.right; };
    const Film film = film_of(66, 64, 16, scene);
    const Image picture = denoise(film);
    const double left = double(edge.left.radiance);
    const double right = double(edge.right.radiance);
    EXPECT_NEAR(mean_of(picture, 32, 33), left, 4 * 0.013 * left);
    EXPECT_NEAR(mean_of(picture, 33, 34), right, 4 * 0.013 * right);
    EXPECT_LT(root_mean_square_error(picture, scene),
              root_mean_square_error(film.beauty(), scene) / 3);
}

INSTANTIATE_TEST_SUITE_P(
    Of, DenoisedEdge,
    testing::Values(
        Edge{"Albedo", {.radiance = 0.2F, .albedo = 0.2F}, {.radiance = 0.4F, .albedo = 0.4F}},
        Edge{"Normal",
             {.radiance = 0.5F, .normal = {1.0F, 0.0F, 0.0F}},
             {.radiance = 0.6F, .normal = {0.0F, 1.0F, 0.0F}}},
        Edge{"Light", {.radiance = 0.2F}, {.radiance = 0.8F}},
        Edge{"Background",
             {.radiance = 0.5F},
             {.radiance = 0.7F, .albedo = 0, .normal = Vec3(0.0F), .covered = false}}),
    [](const auto& test) { return test.param.name; });

// Stripes of albedo one pixel wide, lit evenly: a texture as fine as there can be.
TEST(Denoise, KeepsTexturesOfAlbedo) {
    const Scene2D scene = [](int x, int) {
        const float albedo = x % 2 == 0 ? 0.2F : 0.6F;
        return Truth{.radiance = albedo, .albedo = albedo};
    };
    const Film film = film_of(64, 48, 16, scene);
    EXPECT_LT(root_mean_square_error(denoise(film), scene),
              root_mean_square_error(film.beauty(), scene) / 3);
}

TEST(Denoise, RemovesAFireflyWithoutSpreadingIt) {
    const Scene2D scene = [](int, int) { return Truth{}; };
    Film film(40, 40);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x) {
            Random random(7, Purpose::test, std::uint64_t(y * 1000 + x));
            add_samples(film, x, y, Truth{}, 15, random);
            const bool firefly = x == 20 && y == 21;
            add_samples(film, x, y, Truth{.radiance = firefly ? 1e4F : 0.5F}, 1, random);
        }
    ASSERT_GT(film.beauty().at(20, 21)[0], 100);
    const Image picture = denoise(film);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 40; ++x)
            ASSERT_NEAR(picture.at(x, y)[0], 0.5F, 0.1F) << x << ", " << y;
}

// Light that is a linear function of the normal, on a sphere, which no average of neighbours is.
TEST(Denoise, FollowsShadingOnCurvedSurfaces) {
    const Scene2D scene = [](int x, int y) {
        const float u = (static_cast<float>(x) - 23.5F) / 30;
        const float v = (static_cast<float>(y) - 23.5F) / 30;
        const Vec3 normal = Vec3(u, v, 1.0F).normalized();
        return Truth{.radiance = 0.5F + 0.4F * normal.x, .normal = normal};
    };
    const Film film = film_of(48, 48, 16, scene);
    EXPECT_LT(root_mean_square_error(denoise(film), scene),
              root_mean_square_error(film.beauty(), scene) / 3);
}

TEST(Denoise, IsFiniteForAnySizeAndNumberOfSamples) {
    const Scene2D scene = [](int x, int y) {
        return (x + y) % 5 == 0
                   ? Truth{.radiance = 1e30F, .albedo = 0, .normal = Vec3(0.0F), .covered = false}
                   : Truth{.radiance = (x % 3 == 0) ? 0.0F : 1e-30F, .albedo = 1, .noise = 1};
    };
    for (const auto& [width, height] :
         {std::pair{1, 1}, {1, 7}, {2, 1}, {31, 17}, {32, 16}, {33, 50}})
        for (const int samples : {0, 1, 2, 3, 16}) {
            const Film film = film_of(width, height, samples, scene);
            const Image picture = denoise(film);
            ASSERT_EQ(picture.width, width);
            ASSERT_EQ(picture.height, height);
            ASSERT_TRUE(finite(picture)) << width << " x " << height << ", " << samples;
            const Image beauty = film.beauty();
            for (std::size_t i = 3; i < beauty.pixels.size(); i += 4)
                ASSERT_EQ(picture.pixels[i], beauty.pixels[i]);
        }
}

TEST(Denoise, OfOneSampleAPixelIsBetterThanIt) {
    const Scene2D scene = [](int x, int) { return Truth{.radiance = x < 40 ? 0.3F : 0.6F}; };
    const Film film = film_of(80, 48, 1, scene);
    EXPECT_LT(root_mean_square_error(denoise(film), scene),
              root_mean_square_error(film.beauty(), scene) / 2);
}

TEST(Denoise, LeavesPixelsWithoutSamplesBlackAndOut) {
    const Scene2D scene = [](int, int) { return Truth{}; };
    Film film(48, 40);
    for (int y = 0; y < 40; ++y)
        for (int x = 0; x < 24; ++x) {
            Random random(7, Purpose::test, std::uint64_t(y * 1000 + x));
            add_samples(film, x, y, Truth{}, 16, random);
        }
    const Image picture = denoise(film);
    EXPECT_EQ(mean_of(picture, 24, 48), 0);
    EXPECT_NEAR(mean_of(picture, 23, 24), 0.5, 4 * 0.05 / std::sqrt(40.0));
}

Truth waves(int x, int y) {
    const float wave =
        std::sin(0.2F * static_cast<float>(x)) * std::cos(0.3F * static_cast<float>(y));
    return {.radiance = 0.5F + 0.3F * wave,
            .albedo = x / 11 % 2 == 0 ? 0.3F : 0.6F,
            .normal = Vec3(wave, 0.0F, 1.0F).normalized()};
}

// Tiles and vectors of pixels begin elsewhere when the picture does; it must not be seen.
TEST(Denoise, HasNoSeams) {
    const Image whole = denoise(film_of(120, 100, 8, waves));
    const Image part = denoise(film_of(100, 90, 8, waves, 13, 5));
    const int reach = 30; // of all steps together
    for (int y = reach; y < part.height - reach; ++y)
        for (int x = reach; x < part.width - reach; ++x)
            for (int c = 0; c < 3; ++c)
                ASSERT_EQ(part.at(x, y)[c], whole.at(x + 13, y + 5)[c]) << x << ", " << y;
}

TEST(Denoise, GivesTheSameBytesOnAnyNumberOfThreads) {
    const Film film = film_of(100, 70, 4, waves);
    const auto on = [&](int threads) {
        const ThreadLimit limit(threads);
        return denoise(film).pixels;
    };
    EXPECT_EQ(on(1), on(2));
}

double relative_error(const Image& picture, const Image& reference) {
    double sum = 0;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            for (int c = 0; c < 3; ++c) {
                const double truth = double(reference.at(x, y)[c]);
                sum += std::pow(double(picture.at(x, y)[c]) - truth, 2) / (truth * truth + 0.01);
            }
    return sum / (3.0 * picture.width * picture.height);
}

TEST(Denoise, BringsARenderedPictureNearerToItsReference) {
    Stage stage;
    stage.film.width = 96;
    stage.film.height = 64;
    stage.camera.from = {0.0F, 1.0F, 3.0F};
    stage.camera.fov = 0.7F;
    stage.lights = {test::even_sky(0.3F), AreaLight{.centre = {-1.0, 3.0, 1.0}}};
    stage.add(test::make_plane(20), test::grey_matte(0.6F), test::move({0.0F, -0.5F, 0.0F}));
    stage.add(test::make_sphere(0.5F, 24), test::grey_matte(0.4F));
    stage.film.samples = 512;
    RenderOptions other;
    other.seed = 5;
    const Image reference = stage.render(other).film.beauty();
    stage.film.samples = 8;
    const Film film = stage.render().film;
    const double raw = relative_error(film.beauty(), reference);
    EXPECT_LT(relative_error(denoise(film), reference), raw / 2) << raw;
}

} // namespace
} // namespace scree
