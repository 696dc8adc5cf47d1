// SPDX-License-Identifier: GPL-3.0-or-later
// Translucent objects against closed forms of transport theory, and against each other.
#include "render/subsurface.h"
#include "tests/support/rendering.h"

#include <gtest/gtest.h>

#include <array>

namespace scree {
namespace {

using test::Stage;

struct Mean {
    double value = 0;
    double error = 0; // standard deviation of the value
};

Mean mean(const Film& film, int channel) {
    const std::vector<ImagePart> parts = film.parts();
    const double pixels = double(film.width()) * double(film.height());
    Mean result;
    double variance = 0;
    for (int y = 0; y < film.height(); ++y)
        for (int x = 0; x < film.width(); ++x) {
            result.value += double(parts.front().image.at(x, y)[channel]) / pixels;
            variance += double(parts.back().image.at(x, y)[channel]) / (pixels * pixels);
        }
    result.error = std::sqrt(variance);
    return result;
}

// A view of the middle of a ball around the origin under a white sky.
Stage furnace(float radius, int samples) {
    Stage stage;
    stage.film.width = stage.film.height = 8;
    stage.film.samples = samples;
    stage.film.depth = 64;
    stage.camera.from = {0.0F, radius, 3 * radius};
    stage.camera.fov = 0.1F;
    stage.lights.push_back(test::even_sky(1));
    return stage;
}

Translucent translucent(const Color& color, const Color& distance, float ior = 1.5F) {
    return {{{color, nullptr}, {}}, distance, 0.3F, ior};
}

Color grey(float v) { return {v, v, v}; }

// Nodes and weights of Gauss & Legendre on [0, 1], by Newton's method.
template <int n>
void gauss(std::array<double, n>& nodes, std::array<double, n>& weights) {
    for (unsigned i = 0; i < n; ++i) {
        double x = std::cos(pi * (i + 0.75) / (n + 0.5));
        double slope = 1;
        for (int step = 0; step < 50; ++step) {
            double before = 1;
            double value = x;
            for (int k = 2; k <= n; ++k)
                before = std::exchange(value, ((2 * k - 1) * x * value - (k - 1) * before) / k);
            slope = n * (x * value - before) / (x * x - 1);
            x -= value / slope;
        }
        nodes[i] = (1 + x) / 2;
        weights[i] = 1 / ((1 - x * x) * slope * slope);
    }
}

// Share of light from all sides that half a space gives back, by Chandrasekhar's H function (1950,
// "Radiative transfer", section 38), iterated.
double half_space(double albedo) {
    constexpr int n = 32;
    std::array<double, n> mu{};
    std::array<double, n> weight{};
    gauss<n>(mu, weight);
    std::array<double, n> h{};
    h.fill(1);
    const double root = std::sqrt(1 - albedo);
    for (double change = 1; change > 1e-7;) {
        change = 0;
        const std::array<double, n> old = h;
        for (unsigned i = 0; i < n; ++i) {
            double sum = 0;
            for (unsigned j = 0; j < n; ++j)
                sum += weight[j] * mu[j] * old[j] / (mu[i] + mu[j]);
            h[i] = 1 / (root + albedo / 2 * sum);
            change = std::max(change, std::abs(h[i] - old[i]));
        }
    }
    double flux = 0;
    for (unsigned i = 0; i < n; ++i)
        flux += weight[i] * h[i] * mu[i];
    return 1 - 2 * root * flux;
}

TEST(Subsurface, MediumOfAColorGivesItBack) {
    for (const float color : {0.05F, 0.2F, 0.5F, 0.8F, 0.95F}) {
        const Medium medium = make_medium(grey(color), grey(1));
        EXPECT_NEAR(half_space(double(medium.albedo.x)), double(color), 0.003) << color;
    }
    EXPECT_EQ(make_medium(grey(1), grey(1)).albedo.x, 1);
    EXPECT_NEAR(make_medium(grey(0), grey(1)).albedo.x, 0, 1e-6);
}

TEST(Subsurface, WhiteVanishesInAWhiteFurnace) {
    for (const float distance : {0.02F, 0.2F, 5.0F})
        for (const bool stretched : {false, true})
            for (const Mis mis : {Mis::both, Mis::light_only, Mis::bsdf_only}) {
                Stage stage = furnace(1, 256);
                Matrix matrix;
                if (stretched)
                    matrix.setScale(Vec3(-1.0F, 0.8F, 1.2F));
                stage.add(test::make_sphere(1, 24, false),
                          translucent(grey(1), Color(1.0F, 0.5F, 0.1F) * distance), matrix);
                RenderOptions options;
                options.mis = mis;
                const RenderResult result = stage.render(options);
                EXPECT_EQ(result.stats.invalid_samples, 0U);
                for (const int channel : {0, 1, 2}) {
                    const Mean m = mean(result.film, channel);
                    // The error of the coat's table, as for plastics.
                    EXPECT_NEAR(m.value, 1, 4 * m.error + 0.003)
                        << distance << " channel " << channel << " mis " << int(mis);
                    EXPECT_LT(m.error, 0.02);
                }
            }
}

// The coat of an index near 1 reflects almost nothing.
TEST(Subsurface, LargeBallShowsItsColor) {
    const Color color(0.95F, 0.8F, 0.2F);
    Stage stage = furnace(1, 256);
    stage.add(test::make_sphere(1, 48, false),
              translucent(color, Color(0.004F, 0.002F, 0.001F), 1.01F));
    const Film film = stage.render().film;
    for (const int channel : {0, 1, 2}) {
        const Mean m = mean(film, channel);
        EXPECT_NEAR(m.value, double(color[channel]), 4 * m.error + 0.004);
        EXPECT_LT(m.error, 0.01);
    }
}

// A medium that only absorbs. Chords of a ball of diameter 1 that begin at a point on it, in
// cosine-distributed directions, have a length of density 2 l, so that a share of
// 2 (1 - (1 + x) exp(-x)) / x^2 of the light gets through; x is the diameter in mean free paths.
double through_ball(double x) { return 2 * (1 - (1 + x) * std::exp(-x)) / (x * x); }

TEST(Subsurface, BlackBallAbsorbsByItsChords) {
    const Color distance(0.05F, 0.1F, 0.3F);
    const Medium medium = make_medium(grey(0), distance);
    Mesh ball = test::make_sphere(1, 64, false);
    Mesh nested = ball;
    append(nested, test::make_sphere(0.5F, 32, false));
    // The mesh, its scale, and obstacles: another part of the same mesh, and other objects, which
    // the walk must not see.
    for (const Mesh& mesh : {ball, nested})
        for (const float scale : {0.5F, 2.0F}) {
            Stage stage = furnace(scale, 512);
            stage.film.depth = 2;
            Matrix matrix;
            matrix.setScale(scale);
            stage.add(mesh, translucent(grey(0), distance, 1.01F), matrix);
            stage.add(test::make_sphere(0.3F * scale, 8), test::grey_matte(0));
            const Film film = stage.render().film;
            for (const int channel : {0, 1, 2}) {
                const Mean m = mean(film, channel);
                const double x = 2 * double(scale / medium.mean_free_path[channel]);
                EXPECT_NEAR(m.value, through_ball(x), 4 * m.error + 0.002) << scale;
                EXPECT_LT(m.error, 0.01);
            }
        }
}

// A channel does not depend on the distances of the others.
TEST(Subsurface, ChannelsAreWeightedRight) {
    const Color color(0.8F, 0.7F, 0.3F);
    const Color distance(0.8F, 0.3F, 0.05F);
    Stage all = furnace(1, 512);
    all.add(test::make_sphere(1, 24, false), translucent(color, distance));
    const Film together = all.render().film;
    for (const int channel : {0, 1, 2}) {
        Stage alone = furnace(1, 512);
        alone.add(test::make_sphere(1, 24, false),
                  translucent(grey(color[channel]), grey(distance[channel])));
        RenderOptions options;
        options.seed = 7;
        const Mean a = mean(together, channel);
        const Mean b = mean(alone.render(options).film, channel);
        EXPECT_NEAR(a.value, b.value, 4 * std::hypot(a.error, b.error)) << channel;
        EXPECT_LT(std::hypot(a.error, b.error), 0.01);
    }
}

TEST(Subsurface, OpenMeshLooksLikePlastic) {
    const Color color(0.8F, 0.5F, 0.2F);
    std::array<Film, 2> films{Film(1, 1), Film(1, 1)};
    const std::array<Material, 2> materials{Material(translucent(color, grey(0.1F))),
                                            Material(Plastic{{{color, nullptr}, {}}, 0.3F, 1.5F})};
    for (const std::size_t i : {0U, 1U}) {
        Stage stage = furnace(1, 1024);
        stage.lights.push_back(Sun{Vec3(1.0F, 1.0F, 0.0F), 2, Color(1.0F, 1.0F, 1.0F), 1.0F});
        stage.add(test::make_plane(2), materials[i]);
        RenderOptions options;
        options.seed = i;
        films[i] = stage.render(options).film;
    }
    for (const int channel : {0, 1, 2}) {
        const Mean a = mean(films[0], channel);
        const Mean b = mean(films[1], channel);
        EXPECT_NEAR(a.value, b.value, 4 * std::hypot(a.error, b.error)) << channel;
        EXPECT_LT(std::hypot(a.error, b.error), 0.01 * b.value);
    }
}

// A bowl, half a ball: light gets out over the rim. The walk ends, and no light is gained.
TEST(Subsurface, HolesAreNoSource) {
    Mesh bowl = test::make_sphere(1, 24, false);
    std::erase_if(bowl.triangles,
                  [&](const Mesh::Triangle& t) { return bowl.positions[t[0]].y > 0.1F; });
    Stage stage = furnace(1, 256);
    stage.add(bowl, translucent(grey(1), grey(0.5F)));
    const RenderResult result = stage.render();
    EXPECT_EQ(result.stats.invalid_samples, 0U);
    const Mean m = mean(result.film, 0);
    EXPECT_LT(m.value, 1.003 + 4 * m.error);
}

TEST(Subsurface, LightAndBsdfSamplingAgree) {
    std::vector<Mean> means;
    for (const Mis mis : {Mis::both, Mis::light_only, Mis::bsdf_only}) {
        Stage stage = furnace(1, 1024);
        stage.lights.clear();
        AreaLight area;
        area.centre = {0.0F, 2.5F, 0.0F};
        area.edge_u *= 4;
        area.edge_v *= 4;
        stage.lights.push_back(area);
        stage.add(test::make_sphere(1, 24), translucent(grey(0.9F), Color(0.3F, 0.1F, 0.2F)));
        RenderOptions options;
        options.mis = mis;
        options.seed = means.size();
        means.push_back(mean(stage.render(options).film, 1));
    }
    for (const std::size_t other : {1U, 2U}) {
        const double error = std::hypot(means[0].error, means[other].error);
        EXPECT_NEAR(means[0].value, means[other].value, 4 * error);
        EXPECT_LT(error, 0.02 * means[0].value);
    }
}

TEST(Subsurface, SamePixelsOnAnyThreads) {
    Stage stage = furnace(1, 5);
    stage.film.width = stage.film.height = 40;
    stage.camera.fov = 0.8F;
    stage.add(test::make_sphere(1, 12), translucent(grey(0.9F), Color(0.3F, 0.1F, 0.2F)));
    RenderOptions options;
    options.threads = 1;
    const Film one = stage.render(options).film;
    options.threads = 2;
    EXPECT_EQ(one.beauty().pixels, stage.render(options).film.beauty().pixels);
}

} // namespace
} // namespace scree
