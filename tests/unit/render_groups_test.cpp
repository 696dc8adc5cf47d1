// SPDX-License-Identifier: GPL-3.0-or-later
// What a film keeps beside the beauty: light groups and mattes.
#include "tests/support/rendering.h"

#include <gtest/gtest.h>

#include <sstream>

namespace scree {
namespace {

using test::Stage;

// A plane and a ball under a sky, a sun and two area lights, one of which has no group.
Stage lit_stage() {
    Stage stage;
    stage.film.width = 40;
    stage.film.height = 30;
    stage.film.samples = 12;
    stage.film.depth = 5;
    stage.camera.from = {0.0F, 1.0F, 3.0F};
    stage.camera.fov = 0.7F;
    Sky sky = test::even_sky(0.3F);
    sky.group = "day";
    Sun sun;
    sun.group = "day";
    AreaLight key;
    key.centre = {1, 2, 1};
    key.radiance = Color(9.0F, 5.0F, 2.0F);
    key.group = "key";
    AreaLight fill = key;
    fill.centre = {-2, 2, 1};
    fill.group.clear();
    for (AreaLight* light : {&key, &fill}) // face down
        light->edge_v = Vec3(0.0F, 0.0F, -1.0F);
    std::swap(key.edge_u, key.edge_v);
    stage.lights = {sky, key, sun, fill};
    stage.add(test::make_sphere(0.6F, 12, false), test::grey_matte(0.6F));
    stage.add(test::make_plane(4), test::grey_matte(0.5F), test::move(Vec3(0.0F, -0.6F, 0.0F)));
    return stage;
}

const Image& part(const std::vector<ImagePart>& parts, const std::string& name) {
    const auto found = std::ranges::find(parts, name, &ImagePart::name);
    if (found == parts.end())
        throw std::runtime_error("no part " + name);
    return found->image;
}

TEST(LightGroups, AreNamedInTheOrderOfTheLights) {
    const LightGroups groups = light_groups(lit_stage().lights);
    EXPECT_EQ(groups.names, (std::vector<std::string>{"day", "key", "rest"}));
    EXPECT_EQ(groups.of, (std::vector<std::uint32_t>{0, 1, 0, 2}));
    EXPECT_TRUE(light_groups(std::vector<Light>{Sun{}, Sky{}}).names.empty());
}

// Together they are the beauty; each is the picture that its lights alone would make.
TEST(LightGroups, AddUpToThePicture) {
    Stage stage = lit_stage();
    const std::vector<ImagePart> parts = stage.render().film.parts();
    const Image& beauty = part(parts, "beauty");
    for (std::size_t i = 0; i < beauty.pixels.size(); ++i) {
        if (i % 4 == 3)
            continue; // alpha
        const std::size_t at = i / 4 * 3 + i % 4;
        const float sum = part(parts, "light_day").pixels[at] +
                          part(parts, "light_key").pixels[at] +
                          part(parts, "light_rest").pixels[at];
        EXPECT_NEAR(sum, beauty.pixels[i], 1e-5F * (1 + beauty.pixels[i]));
    }
}

TEST(LightGroups, AreWhatTheirLightsAloneGive) {
    Stage stage = lit_stage();
    stage.film.samples = 256;
    const std::vector<ImagePart> together = stage.render().film.parts();
    stage.lights = {stage.lights[1]};
    const std::vector<ImagePart> alone = stage.render().film.parts();
    const auto mean = [](const Image& image, std::size_t channels) {
        double sum = 0;
        for (std::size_t i = 0; i < image.pixels.size(); i += channels)
            sum += double(image.pixels[i]);
        return sum * double(channels) / double(image.pixels.size());
    };
    const double expected = mean(part(alone, "beauty"), 4);
    EXPECT_NEAR(mean(part(together, "light_key"), 3), expected, 0.01 * expected);
}

TEST(Mattes, CountTheSamplesOfWhatIsSeenFirst) {
    Stage stage = lit_stage();
    RenderOptions options;
    options.mattes = true;
    const RenderResult result = stage.render(options);
    const Image beauty = result.film.beauty();
    bool mixed = false;
    for (int y = 0; y < beauty.height; ++y)
        for (int x = 0; x < beauty.width; ++x) {
            std::uint32_t samples = 0;
            for (const Seen& seen : result.film.seen(x, y)) {
                EXPECT_LT(seen.instance, 2U);
                samples += seen.samples;
            }
            mixed = mixed || result.film.seen(x, y).size() == 2;
            // Alpha also counts the area lights, which are no instances.
            EXPECT_LE(samples, std::uint32_t(std::lround(beauty.at(x, y)[3] * 12)));
        }
    EXPECT_TRUE(mixed);
    EXPECT_EQ(beauty.pixels, stage.render().film.beauty().pixels);
}

TEST(Mattes, AndGroupsAreKeptByACheckpoint) {
    const Stage stage = lit_stage();
    const World world(stage.aggregates, stage.lights);
    RenderOptions options;
    options.mattes = true;
    const Film whole = render(world, stage.camera, stage.film, options).film;
    Rendering first(world, stage.camera, stage.film, options);
    first.pass();
    std::stringstream state;
    first.save(state);
    Rendering second(world, stage.camera, stage.film, options);
    second.restore(state);
    second.step(1000);
    const std::vector<ImagePart> expected = whole.parts();
    const std::vector<ImagePart> parts = second.film().parts();
    ASSERT_EQ(parts.size(), expected.size());
    for (std::size_t i = 0; i < parts.size(); ++i)
        EXPECT_EQ(parts[i].image.pixels, expected[i].image.pixels) << parts[i].name;
    for (int y = 0; y < whole.height(); ++y)
        for (int x = 0; x < whole.width(); ++x)
            EXPECT_TRUE(std::ranges::equal(second.film().seen(x, y), whole.seen(x, y)));
}

} // namespace
} // namespace scree
