// SPDX-License-Identifier: GPL-3.0-or-later
// procedural.image, alone and in the renderer's hits.
#include "core/random.h"
#include "model/picture_texture.h"
#include "procedurals/table.h"
#include "tests/support/pictures.h"
#include "tests/support/plugin_params.h"

#include <gtest/gtest.h>

namespace scree {
namespace {

using test::picture_of;

Color color_at(const Procedural& procedural, const Vec2f& uv, float footprint = 0) {
    const ShadingPoint point{{}, 0, uv, footprint};
    ShadingSample sample;
    procedural.evaluate({&point, 1}, {&sample, 1});
    return sample.color;
}

std::shared_ptr<const Procedural> made(std::map<std::string, Value> values) {
    return tests::make(procedural_table(), "image", values);
}

// The left half is red, the right half transparent; sRGB 188 is 0.5 in linear light.
Image half_red() {
    Image image(8, 8, {"R", "G", "B", "A"});
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 4; ++x) {
            image.at(x, y)[0] = 188 / 255.0F;
            image.at(x, y)[3] = 1;
        }
    return image;
}

TEST(ImageTexture, IsLinearAndCleanAtItsOutline) {
    const test::Folder folder;
    const std::string path = folder.file("half.png");
    write_png(path, half_red());
    const auto texture = made({{"path", path}});
    EXPECT_NEAR(color_at(*texture, {0.2F, 0.5F}).x, 0.5F, 0.005);
    for (const float x : {0.45F, 0.5F, 0.55F, 0.7F, 0.99F}) // not darker beyond the outline
        EXPECT_NEAR(color_at(*texture, {x, 0.5F}).x, 0.5F, 0.005) << x;
    const auto on_blue = made({{"path", path}, {"ground", Color(0, 0, 0.8F)}});
    EXPECT_NEAR(color_at(*on_blue, {0.8F, 0.5F}).z, 0.8F, 1e-5);
    EXPECT_NEAR(color_at(*on_blue, {0.5F, 0.5F}).z, 0.4F, 1e-5);
    const auto repeated = made({{"path", path}, {"repeats", true}, {"ground", Color(0.0F)}});
    EXPECT_NEAR(color_at(*repeated, {-0.8F, 7.3F}).x, 0.5F, 0.005);
    EXPECT_NEAR(color_at(*repeated, {3.8F, 0.3F}).x, 0.0F, 1e-5);
    EXPECT_THROW(made({{"path", folder.file("none.png")}}), Error);

    // Three by two copies: a point shows what the picture shows at three and two times its place.
    const auto copies =
        made({{"path", path}, {"repeats", true}, {"copies", Vec2(3, 2)}, {"ground", Color(0.0F)}});
    for (const Vec2f& uv : {Vec2f(0.07F, 0.2F), Vec2f(0.25F, 0.9F), Vec2f(0.4F, 0.6F)})
        EXPECT_NEAR(color_at(*copies, uv).x, color_at(*repeated, {3 * uv.x, 2 * uv.y}).x, 1e-6F);
    EXPECT_GT(color_at(*copies, {0.4F, 0.6F}).x, 0.4F);
    EXPECT_LT(color_at(*copies, {0.25F, 0.9F}).x, 0.01F);
}

TEST(ImageTexture, IsUprightAndFiltered) {
    Random random(1, Purpose::test, 0);
    Picture picture{"",
                    picture_of(64, 64,
                               [&](double, double y) {
                                   const float v = random.uniform_float();
                                   return std::array{v, y < 0.5 ? 1.0F : 0.0F, 0.0F, 1.0F};
                               }),
                    {},
                    {}};
    const auto texture = picture_texture(picture.image);
    EXPECT_EQ(color_at(*texture, {0.5F, 0.9F}).y, 1.0F); // the top
    EXPECT_NEAR(color_at(*texture, {0.5F, 0.5F}, 1).x, 0.5F, 0.05F);
    EXPECT_NEAR(color_at(*texture, {0.5F, 0.5F}, 1).y, 0.5F, 0.05F);
}

} // namespace
} // namespace scree
