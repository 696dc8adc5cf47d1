// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/error.h"
#include "core/file.h"
#include "core/random.h"
#include "geometry/plane/height_field.h"
#include "tests/support/folder.h"

#include <gtest/gtest.h>

#include <limits>

namespace scree {
namespace {

HeightField random_field(int width, int height, std::vector<std::string> channels) {
    HeightField field;
    field.size = {0.04, 0.03};
    field.image = Image(width, height, std::move(channels));
    Random random(1, Purpose::test);
    for (float& v : field.image.pixels)
        v = static_cast<float>(random.uniform(-1e-3, 1e-3));
    return field;
}

Vec2 centre_of(const HeightField& field, int x, int y) {
    return {(x + 0.5) / field.image.width, 1 - (y + 0.5) / field.image.height};
}

class HeightFile : public testing::Test {
  protected:
    std::string path(const std::string& name) const { return folder_.file(name); }
    std::string message_of(const std::string& name) const {
        try {
            read_height(path(name));
        } catch (const Error& error) {
            return error.what();
        }
        return "no error";
    }
    test::Folder folder_;
};

TEST(HeightField, MeetsItsPixelsAtTheirCentres) {
    const HeightField field = random_field(7, 5, {"Y"});
    for (int y = 0; y < 5; ++y)
        for (int x = 0; x < 7; ++x) {
            // Rounding moves the position by up to 1e-15 of a pixel.
            EXPECT_NEAR(field.height(centre_of(field, x, y)), *field.image.at(x, y), 1e-9);
            EXPECT_NEAR(field.height(centre_of(field, x, y) + Vec2(3, -2)), *field.image.at(x, y),
                        1e-9)
                << "it tiles";
        }
}

TEST(HeightField, IsExactOnAPlaneAndKeepsItsBorderWhenItDoesNotTile) {
    HeightField field;
    field.tiles = false;
    field.image = Image(8, 8, {"Y"});
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
            *field.image.at(x, y) = static_cast<float>(2 * x - 3 * y);
    for (const Vec2& uv : {Vec2(0.4, 0.5), Vec2(0.31, 0.62), Vec2(0.7, 0.33)})
        EXPECT_NEAR(field.height(uv), 2 * (8 * uv.x - 0.5) - 3 * (8 * (1 - uv.y) - 0.5), 1e-5);
    EXPECT_FLOAT_EQ(field.height({-5.0, 1 - 0.5 / 8}), 0.0F);
    EXPECT_FLOAT_EQ(field.height({9.0, 1 - 0.5 / 8}), 14.0F);
}

TEST(HeightField, HasAContinuousSlopeAcrossItsBorder) {
    const HeightField field = random_field(16, 16, {"Y"});
    const double step = 1e-4;
    for (int k = 0; k < 64; ++k) {
        const double v = (k + 0.37) / 64;
        const auto slope = [&](double u) {
            return (field.height({u + step, v}) - field.height({u, v})) / step;
        };
        // Second derivatives are at most about 20 per square pixel for heights of 1e-3; pixels are
        // 1/16 wide.
        EXPECT_NEAR(slope(-step), slope(0), 20 * 1e-3 * 256 * 2 * step) << v;
        EXPECT_NEAR(field.height({-1e-9, v}), field.height({1e-9, v}), 1e-8);
    }
}

TEST(HeightField, HeightsAndVectorsChangeIntoEachOther) {
    const HeightField heights = random_field(6, 4, {"Y"});
    const HeightField vectors = heights.as_vector();
    EXPECT_TRUE(vectors.is_vector());
    EXPECT_EQ(vectors.as_height().image.pixels, heights.image.pixels);
    const Vec3 offset = vectors.offset({0.3, 0.6});
    EXPECT_EQ(offset, Vec3(0.0F, heights.height({0.3, 0.6}), 0.0F));
    EXPECT_EQ(heights.offset({0.3, 0.6}), offset);
}

TEST_F(HeightFile, ComesBackAsItWas) {
    for (const std::vector<std::string>& channels :
         {std::vector<std::string>{"Y"}, std::vector<std::string>{"R", "G", "B"}}) {
        HeightField field = random_field(9, 6, channels);
        field.mid_level = 0.25;
        field.tiles = false;
        write_height(path("a.exr"), field, {{"scree:scene", "x.lua"}});
        const HeightField back = read_height(path("a.exr"));
        EXPECT_EQ(back.image.channels, field.image.channels);
        EXPECT_EQ(back.image.pixels, field.image.pixels) << "32-bit floats lose nothing";
        EXPECT_EQ(back.size, Vec2(0.04F, 0.03F));
        EXPECT_EQ(back.mid_level, 0.25);
        EXPECT_FALSE(back.tiles);
        const ExrFile file = read_exr(path("a.exr"));
        EXPECT_EQ(file.metadata, (Metadata{{"scree:scene", "x.lua"}}));
        EXPECT_TRUE(file.parts.front().full_float);
        EXPECT_EQ(read_data_image(path("a.exr")).pixels, field.image.pixels);
    }
}

TEST_F(HeightFile, WrongFilesAreNamed) {
    ImagePart part{"height", Image(2, 2, {"Y"}), true};
    write_exr(path("bare.exr"), std::span(&part, 1), {});
    EXPECT_EQ(message_of("bare.exr"),
              path("bare.exr") + ": its header has no worldSize; expected two numbers in metres");
    write_exr(path("flat.exr"), std::span(&part, 1), {}, {{"worldSize", {0.0F, 1.0F}}});
    EXPECT_EQ(message_of("flat.exr"), path("flat.exr") + ": its worldSize must be above 0");
    part.image.pixels[2] = std::numeric_limits<float>::quiet_NaN();
    write_exr(path("nan.exr"), std::span(&part, 1), {}, {{"worldSize", {1.0F, 1.0F}}});
    EXPECT_EQ(message_of("nan.exr"), path("nan.exr") + ": holds values that are not finite");
    part.image = Image(2, 2, {"R", "G"});
    write_exr(path("two.exr"), std::span(&part, 1), {}, {{"worldSize", {1.0F, 1.0F}}});
    EXPECT_EQ(message_of("two.exr"),
              path("two.exr") + ": is not a height map: expected channel Y, or R, G and B");
    write_file(path("text.exr"), "no image");
    EXPECT_EQ(message_of("text.exr"), path("text.exr") + ": is not a PNG, JPEG, EXR or HDR image");
}

} // namespace
} // namespace scree
