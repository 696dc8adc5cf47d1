// SPDX-License-Identifier: GPL-3.0-or-later
// Whole pictures against closed forms, and against each other.
#include "core/error.h"
#include "core/random.h"
#include "tests/support/rendering.h"

#include <gtest/gtest.h>

#include <atomic>

namespace scree {
namespace {

using test::Stage;

constexpr double alpha = 1e-4; // chance of a false alarm per test; seeds are fixed

struct Mean {
    double value = 0;
    double variance = 0; // of the mean
};

// Mean over the picture of one channel.
Mean mean(const Film& film, int channel) {
    const std::vector<ImagePart> parts = film.parts();
    const Image& beauty = parts.front().image;
    const Image& variance = parts.back().image;
    Mean result;
    const double pixels = double(film.width()) * double(film.height());
    for (int y = 0; y < film.height(); ++y)
        for (int x = 0; x < film.width(); ++x) {
            result.value += double(beauty.at(x, y)[channel]) / pixels;
            result.variance += double(variance.at(x, y)[channel]) / (pixels * pixels);
        }
    return result;
}

Stage small_stage(int side, int samples, int depth) {
    Stage stage;
    stage.film.width = stage.film.height = side;
    stage.film.samples = samples;
    stage.film.depth = depth;
    stage.camera.from = {0.0F, 1.0F, 3.0F};
    stage.camera.fov = 0.7F;
    return stage;
}

// White objects under a white sky cannot be seen. With flat normals: soft terminators lose light.
TEST(Furnace, WhiteMattesVanishInEveryPixel) {
    Stage stage = small_stage(24, 64, 200);
    stage.lights.push_back(test::even_sky(1));
    stage.add(test::make_sphere(0.6F, 12, false), test::grey_matte(1));
    stage.add(test::make_sphere(0.5F, 12, false), test::grey_matte(1),
              test::move(Vec3(0.9F, 0.0F, 0.0F)));
    stage.add(test::make_plane(4), test::grey_matte(1), test::move(Vec3(0.0F, -0.6F, 0.0F)));
    for (const Mis mis : {Mis::both, Mis::light_only, Mis::bsdf_only}) {
        RenderOptions options;
        options.mis = mis;
        const RenderResult result = stage.render(options);
        const std::vector<ImagePart> parts = result.film.parts();
        const double limit = test::sidak_quantile(alpha, 24 * 24);
        for (int y = 0; y < 24; ++y)
            for (int x = 0; x < 24; ++x) {
                const double error = std::sqrt(double(parts.back().image.at(x, y)[0]) + 1e-10);
                EXPECT_LT(std::abs(double(parts.front().image.at(x, y)[0]) - 1) / error, limit)
                    << x << "," << y << " mis " << int(mis);
            }
        EXPECT_EQ(result.stats.invalid_samples, 0U);
    }
}

// White, with a roughness that takes all values from the bottom to the top.
class Bands final : public Procedural {
  public:
    void evaluate(std::span<const ShadingPoint> points,
                  std::span<ShadingSample> samples) const override {
        for (std::size_t i = 0; i < points.size(); ++i) {
            samples[i] = {};
            samples[i].color = {1.0F, 1.0F, 1.0F};
            samples[i].roughness = 0.5F + 0.5F * std::sin(20 * points[i].position.y);
        }
    }
};

TEST(Furnace, OtherMaterialsNeverGain) {
    const Texture white{Color(1.0F, 1.0F, 1.0F), nullptr};
    const Texture bands{Color(1.0F, 1.0F, 1.0F), std::make_shared<Bands>()};
    const std::vector<std::pair<Material, double>> least = {
        {Metal{{white, {}}, 0.3F}, 0.98},
        {Metal{{white, {}}, 1.0F}, 0.98},
        {Plastic{{white, {}}, 0.1F, 1.5F}, 0.98},
        {Plastic{{white, {}}, 0.7F, 1.5F}, 0.98},
        {Metal{{bands, {}}, 0.3F}, 0.98},
        {Plastic{{bands, {}}, 0.3F, 1.5F}, 0.98},
        {Glass{1.5F, Color(0.0F, 0.0F, 0.0F), 0}, 0.999},
        {Glass{1.5F, Color(0.0F, 0.0F, 0.0F), 0.4F}, 0.9}};
    for (std::size_t i = 0; i < least.size(); ++i)
        for (const bool smooth : {false, true}) {
            Stage stage = small_stage(16, 64, 200);
            stage.lights.push_back(test::even_sky(1));
            stage.camera.fov = 0.25F;
            stage.add(test::make_sphere(0.6F, 48, smooth), least[i].first);
            const Mean m = mean(stage.render().film, 0);
            EXPECT_LE(m.value, 1.003 + 4 * std::sqrt(m.variance)) << i << smooth;
            EXPECT_GE(m.value, least[i].second - (smooth ? 0.03 : 0.0)) << i << smooth;
        }
}

TEST(Integrator, LightAndBsdfSamplingAgree) {
    Stage stage = small_stage(32, 256, 4);
    const Texture grey{Color(0.7F, 0.7F, 0.7F), nullptr};
    stage.add(test::make_plane(6), Metal{{grey, {}}, 0.5F});
    stage.add(test::make_sphere(0.3F, 16), Plastic{{grey, {}}, 0.4F, 1.5F},
              test::move(Vec3(0.5F, 0.3F, 0.0F)));
    AreaLight area;
    area.centre = {0.0F, 1.2F, -0.6F};
    area.radiance = {4.0F, 4.0F, 4.0F};
    stage.lights.push_back(area);
    Sky sky;
    sky.ground = {0.1F, 0.1F, 0.1F};
    sky.horizon = {0.2F, 0.3F, 0.4F};
    stage.lights.push_back(sky);
    stage.lights.push_back(Sun{Vec3(1.0F, 2.0F, 1.0F), 0.6F, Color(1.0F, 1.0F, 1.0F), 1.0F});
    std::vector<Mean> means;
    std::uint64_t seed = 1;
    for (const Mis mis : {Mis::both, Mis::light_only, Mis::bsdf_only}) {
        RenderOptions options;
        options.mis = mis;
        options.seed = seed++;
        means.push_back(mean(stage.render(options).film, 1));
    }
    for (const std::size_t other : {1U, 2U}) {
        const double difference = means[0].value - means[other].value;
        const double error = std::sqrt(means[0].variance + means[other].variance);
        EXPECT_LT(std::abs(difference) / error, test::sidak_quantile(alpha, 2)) << other;
        EXPECT_LT(error, 0.01 * means[0].value) << "too noisy to tell anything";
    }
    EXPECT_LT(means[0].variance, means[1].variance);
    EXPECT_LT(means[0].variance, means[2].variance);
}

// A plate of radiance 1 over a plate of reflectance r, distance 0.5, side 1: the centre of the
// lower one shows r F, F the form factor of a patch to a parallel square above it (Howell, "A
// catalog of radiation heat transfer configuration factors", B-3, four times).
TEST(Integrator, ParallelPlatesClosedForm) {
    Stage stage = small_stage(1, 1 << 14, 2);
    stage.add(test::make_plane(1), test::grey_matte(0.6F));
    AreaLight area;
    area.centre = {0.0F, 0.5F, 0.0F};
    stage.lights.push_back(area);
    stage.camera.from = {0.6F, 0.2F, 0.0F};
    stage.camera.fov = 0.002F;
    const double a = 0.5 / 0.5; // half side over distance
    const double root = std::sqrt(1 + a * a);
    const double factor = 4 / (2 * pi) * 2 * (a / root) * std::atan(a / root);
    for (const Mis mis : {Mis::both, Mis::light_only, Mis::bsdf_only}) {
        RenderOptions options;
        options.mis = mis;
        const Mean m = mean(stage.render(options).film, 0);
        EXPECT_NEAR(m.value, 0.6 * factor, 5 * std::sqrt(m.variance) + 1e-4) << int(mis);
        EXPECT_LT(std::sqrt(m.variance), 0.005);
    }
}

// A sphere of reflectance r from inside, with a sky that shows through a small round hole of solid
// angle share s: of the light that a bounce scatters, the share s of its cosine-weighted area
// escapes, everywhere the same in a sphere. Seen away from the hole, the radiance is
// r s / (1 - r (1 - s)), the integrating sphere's equation (Jacquez & Kuppenheim 1955).
TEST(Integrator, IntegratingSphere) {
    Mesh sphere = test::make_sphere(1, 96, false);
    const double whole = area(sphere);
    std::erase_if(sphere.triangles, [&](const Mesh::Triangle& t) {
        return sphere.positions[t[0]].y > 0.8F && sphere.positions[t[1]].y > 0.8F &&
               sphere.positions[t[2]].y > 0.8F;
    });
    const double hole = 1 - area(sphere) / whole;
    for (const double r : {0.5, 0.9}) {
        Stage stage = small_stage(8, 1024, 500);
        stage.add(sphere, test::grey_matte(static_cast<float>(r)));
        stage.lights.push_back(test::even_sky(1));
        stage.camera.from = {0.0F, 0.0F, 0.0F};
        stage.camera.at = {1.0F, -0.5F, 0.0F};
        const Mean m = mean(stage.render().film, 0);
        EXPECT_NEAR(m.value, r * hole / (1 - r * (1 - hole)),
                    4 * std::sqrt(m.variance) + 0.002 * m.value)
            << r;
        EXPECT_LT(std::sqrt(m.variance), 0.01 * m.value);
    }
}

TEST(Integrator, GlassAbsorbsByBeer) {
    Stage stage = small_stage(1, 4096, 100);
    Mesh slab = test::make_plane(4);
    Mesh lower = slab;
    for (Vec3& p : lower.positions)
        p.y -= 0.5F;
    for (Mesh::Triangle& t : lower.triangles)
        std::swap(t[1], t[2]);
    append(slab, lower);
    stage.add(slab, Glass{1.5F, Color(1.0F, 0.0F, 3.0F), 0});
    Sky sky;
    sky.zenith = sky.horizon = {0.0F, 0.0F, 0.0F};
    sky.ground = {1.0F, 1.0F, 1.0F};
    stage.lights.push_back(sky);
    stage.camera.from = {0.0F, 1.0F, 0.0F};
    stage.camera.up = {0.0F, 0.0F, 1.0F};
    stage.camera.fov = 0.001F;
    const Film film = stage.render().film;
    for (const auto& [channel, density] :
         {std::pair{0, 1.0}, std::pair{1, 0.0}, std::pair{2, 3.0}}) {
        const double reflected = 0.04; // ((1.5 - 1) / (1.5 + 1))^2
        const double left = std::exp(-density * 0.5);
        const double through =
            (1 - reflected) * (1 - reflected) * left / (1 - reflected * reflected * left * left);
        const Mean m = mean(film, channel);
        EXPECT_NEAR(m.value, through, 5 * std::sqrt(m.variance) + 1e-3) << channel;
    }
}

TEST(Render, SamePixelsOnAnyThreadsTilesAndCrop) {
    Stage stage = small_stage(40, 7, 6);
    stage.add(test::make_plane(6), test::grey_matte(0.5F));
    stage.add(test::make_sphere(0.5F, 16), Glass{}, test::move(Vec3(0.0F, 0.5F, 0.0F)));
    stage.lights.push_back(test::even_sky(1));
    stage.lights.push_back(Sun{});
    stage.camera.aperture = 0.05F;
    RenderOptions options;
    options.threads = 1;
    const Film one = stage.render(options).film;
    options.threads = 2;
    const Film two = stage.render(options).film;
    for (std::size_t part = 0; part < one.parts().size(); ++part)
        EXPECT_EQ(one.parts()[part].image.pixels, two.parts()[part].image.pixels);
    options.crop = Crop{5, 9, 20, 13};
    const Image crop = stage.render(options).film.beauty();
    const Image full = one.beauty();
    for (int y = 0; y < 13; ++y)
        for (int x = 0; x < 20; ++x)
            for (int c = 0; c < 4; ++c)
                ASSERT_EQ(crop.at(x, y)[c], full.at(x + 5, y + 9)[c]);
    options.crop = Crop{30, 0, 20, 10};
    EXPECT_THROW(stage.render(options), Error);
    options.crop.reset();
    options.seed = 1;
    EXPECT_NE(stage.render(options).film.beauty().pixels, full.pixels);
}

TEST(Render, StopsOnCancelTimeAndNoise) {
    Stage stage = small_stage(32, 1 << 20, 4);
    stage.add(test::make_plane(6), test::grey_matte(0.5F));
    stage.lights.push_back(test::even_sky(1));
    RenderOptions options;
    options.time_limit = 0.2;
    const RenderResult timed = stage.render(options);
    EXPECT_FALSE(timed.cancelled);
    EXPECT_GE(timed.stats.samples_per_pixel, 1);
    EXPECT_LT(timed.stats.seconds, 5);
    options = {};
    options.noise = 0.05;
    const RenderResult quiet = stage.render(options);
    EXPECT_LT(quiet.stats.error, 0.05);
    EXPECT_LT(quiet.stats.samples_per_pixel, 1000);
    Cancel cancel;
    Context context;
    context.cancel = &cancel;
    options = {};
    const World world(stage.aggregates, stage.lights);
    Rendering rendering(world, stage.camera, stage.film, options, context);
    while (rendering.samples() < 8)
        rendering.pass();
    cancel.request();
    rendering.step(1000);
    EXPECT_TRUE(rendering.cancelled());
    EXPECT_EQ(rendering.stats().samples_per_pixel, 8);
}

// Requests the cancel at its n-th evaluation.
class CancelsAt final : public Procedural {
  public:
    CancelsAt(Cancel& cancel, int evaluations) : cancel_(cancel), left_(evaluations) {}
    void evaluate(std::span<const ShadingPoint> points,
                  std::span<ShadingSample> samples) const override {
        std::fill(samples.begin(), samples.end(), ShadingSample{});
        if ((left_ -= static_cast<int>(points.size())) <= 0)
            cancel_.request();
    }

  private:
    Cancel& cancel_;
    mutable std::atomic<int> left_;
};

TEST(Render, APassThatIsCancelledDoesNotCountItsSamples) {
    Stage stage = small_stage(32, 1 << 20, 2);
    Cancel cancel;
    // In the second pass, within a tile.
    const Paint paint{{Color(0.0F), std::make_shared<CancelsAt>(cancel, 32 * 32 + 20)}, {}};
    stage.camera.from = {0.0F, 1.0F, 0.0F};
    stage.camera.up = {0.0F, 0.0F, 1.0F};
    stage.add(test::make_plane(10), Matte{paint});
    Context context;
    context.cancel = &cancel;
    std::vector<int> passes;
    RenderOptions options;
    options.threads = 1;
    const World world(stage.aggregates, stage.lights);
    Rendering rendering(world, stage.camera, stage.film, options, context);
    while (!rendering.cancelled()) {
        rendering.pass();
        passes.push_back(rendering.samples());
    }
    EXPECT_EQ(passes, (std::vector<int>{1, 1}));
    EXPECT_GT(rendering.stats().samples_per_pixel, 1);
    EXPECT_LT(rendering.stats().samples_per_pixel, 1.25) << "a tile is a quarter of the picture";
}

TEST(Film, VarianceOfTheMeanIsRight) {
    // 2000 pixels of 16 uniform numbers: the mean of the estimates is 1 / (12 * 16).
    Film film(2000, 1);
    Random random(8, Purpose::test);
    for (int x = 0; x < 2000; ++x)
        for (int i = 0; i < 16; ++i) {
            PathSample sample;
            const float v = random.uniform_float();
            sample.radiance = {v, v, v};
            film.add(x, 0, sample, 0);
        }
    const std::vector<ImagePart> parts = film.parts();
    double sum = 0;
    for (const float v : parts.back().image.pixels)
        sum += double(v) / 6000;
    EXPECT_NEAR(sum, 1 / (12.0 * 16), 0.02 / (12.0 * 16));
}

TEST(Film, DropsInvalidSamples) {
    Film film(1, 1);
    PathSample sample;
    for (const float bad : {NAN, INFINITY, -1.0F}) {
        sample.radiance = {0.0F, bad, 0.0F};
        EXPECT_FALSE(film.add(0, 0, sample, 0));
    }
    EXPECT_EQ(film.samples(0, 0), 0U);
    sample.radiance = {1.0F, 2.0F, 3.0F};
    EXPECT_TRUE(film.add(0, 0, sample, 0));
    EXPECT_EQ(film.beauty().pixels, (std::vector<float>{1, 2, 3, 0}));
}

} // namespace
} // namespace scree
