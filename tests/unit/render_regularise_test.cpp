// SPDX-License-Identifier: GPL-3.0-or-later
// Roughening after diffuse bounces: less noise where caustics are, and little light lost.
#include "tests/support/rendering.h"

#include <gtest/gtest.h>

namespace scree {
namespace {

using test::Stage;

// A small bright lamp over a glass ball: the light behind the ball is a caustic that paths find by
// chance. The ball's own highlights are as they were, so the camera looks past it.
Stage caustic_stage(float regularise) {
    Stage stage;
    stage.film.width = 24;
    stage.film.height = 16;
    stage.film.samples = 512;
    stage.film.depth = 6;
    stage.film.regularise = regularise;
    stage.camera.from = {-3.0F, 2.0F, 0.0F};
    stage.camera.at = {-1.2F, -0.5F, 0.0F};
    stage.camera.fov = 0.25F;
    AreaLight lamp; // faces down
    lamp.centre = {1, 2, 0};
    lamp.edge_u = Vec3(0.0F, 0.0F, -0.1F);
    lamp.edge_v = Vec3(-0.1F, 0.0F, 0.0F);
    if (lamp.normal().y > 0)
        std::swap(lamp.edge_u, lamp.edge_v);
    lamp.radiance = Color(300.0F, 300.0F, 300.0F);
    stage.lights = {lamp};
    stage.add(test::make_sphere(0.5F, 40), Glass{});
    stage.add(test::make_plane(8), test::grey_matte(0.6F), test::move(Vec3(0.0F, -0.5F, 0.0F)));
    return stage;
}

struct Measured {
    double mean = 0;
    double variance = 0;
};

Measured measured(const Film& film) {
    Measured sum;
    for (int y = 0; y < film.height(); ++y)
        for (int x = 0; x < film.width(); ++x) {
            sum.mean += film.luminance_at(x, y);
            sum.variance += film.luminance_variance(x, y);
        }
    return sum;
}

TEST(Regularise, LessNoiseAndAboutAsMuchLight) {
    const Measured exact = measured(caustic_stage(0).render().film);
    const Measured soft = measured(caustic_stage(0.3F).render().film);
    EXPECT_LT(soft.variance, 0.5 * exact.variance);
    EXPECT_NEAR(soft.mean, exact.mean, 0.06 * exact.mean);
}

// What the camera sees directly stays sharp.
TEST(Regularise, LeavesDirectViewsAsTheyAre) {
    Stage stage = caustic_stage(0);
    stage.film.samples = 16;
    stage.aggregates.pop_back(); // the floor: nothing is diffuse
    const Image exact = stage.render().film.beauty();
    stage.film.regularise = 0.5F;
    EXPECT_EQ(stage.render().film.beauty().pixels, exact.pixels);
}

TEST(Regularise, RoughensWhatHasFacets) {
    const auto roughness_of = [](const Material& material) {
        return std::visit(
            [](const auto& m) {
                if constexpr (requires { m.roughness; })
                    return m.roughness;
                else
                    return -1.0F;
            },
            roughened(material, 0.3F));
    };
    Plastic rough;
    rough.roughness = 0.5F;
    EXPECT_EQ(roughness_of(Metal{}), 0.3F);
    EXPECT_EQ(roughness_of(Glass{}), 0.3F);
    EXPECT_EQ(roughness_of(rough), 0.5F);
    EXPECT_EQ(roughness_of(Matte{}), -1);
}

} // namespace
} // namespace scree
