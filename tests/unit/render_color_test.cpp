// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/film/color.h"

#include "core/error.h"
#include "core/file.h"
#include "core/math.h"
#include "tests/support/folder.h"

#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>

namespace scree {
namespace {

Image one_pixel(float v) {
    Image image(1, 1, {"R", "G", "B", "A"});
    image.pixels = {v, v, v, 1.0F};
    return image;
}

TEST(Color, StandardViewIsSrgb) {
    EXPECT_NEAR(to_display(one_pixel(0.18F), "standard").pixels[0], 0.46136F, 1e-4F);
    EXPECT_NEAR(to_display(one_pixel(0.001F), "standard").pixels[1], 0.01292F, 1e-4F);
    EXPECT_NEAR(to_display(one_pixel(0.09F), "standard", 1).pixels[2], 0.46136F, 1e-4F);
}

TEST(Color, FilmicViewFollowsItsCurve) {
    for (const float v : {0.0F, 0.01F, 0.18F, 0.4F, 1.0F, 5.0F, 100.0F}) {
        const double curve = filmic_curve(double(v));
        const double expected =
            curve <= 0.0031308 ? 12.92 * curve : 1.055 * std::pow(curve, 1 / 2.4) - 0.055;
        EXPECT_NEAR(double(to_display(one_pixel(v)).pixels[0]), expected, 1e-3) << v;
    }
    EXPECT_DOUBLE_EQ(filmic_curve(0.3), 0.3); // straight in the middle
    for (double x = 0; x < 4; x += 0.01)      // rising, never clipped
        EXPECT_LT(filmic_curve(x), filmic_curve(x + 0.01));
    EXPECT_LE(filmic_curve(1e6), 1);
}

Color shown(const Color& color, const std::string& view) {
    Image image(1, 1, {"R", "G", "B"});
    image.pixels = {color.x, color.y, color.z};
    const Image out = to_display(image, view);
    return {out.pixels[0], out.pixels[1], out.pixels[2]};
}

// A red lamp that is made brighter: red at first, white in the end, never magenta or yellow.
TEST(Color, FilmicTurnsBrightColorsWhite) {
    const Color dim = shown(Color(0.5F, 0.0F, 0.0F), "filmic");
    EXPECT_GT(dim.x, 0.7F);
    EXPECT_LT(dim.y, 0.01F);
    float before = 0;
    for (float strength = 1; strength < 1000; strength *= 2) {
        const Color lamp = shown(Color(strength, 0.0F, 0.0F), "filmic");
        EXPECT_GE(std::max(0.0F, lamp.y), before) << strength;
        EXPECT_NEAR(lamp.y, lamp.z, 1e-5F) << strength;
        before = std::max(0.0F, lamp.y);
    }
    EXPECT_GT(before, 0.95F);
}

// Where all channels lie on the straight part of the curve, a colour is that of sRGB.
TEST(Color, FilmicKeepsColorsOfTheMiddle) {
    const Color color(0.3F, 0.5F, 0.4F);
    const Color filmic = shown(color, "filmic");
    const Color standard = shown(color, "standard");
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(filmic[c], standard[c], 2e-3F);
}

TEST(Color, RawViewShowsValuesAsTheyAre) {
    const Color color(0.25F, 0.5F, 2.0F);
    EXPECT_EQ(shown(color, "raw"), color);
}

TEST(Color, UnknownViewNamesTheOthers) {
    EXPECT_EQ(view_names(), (std::vector<std::string>{"filmic", "standard", "raw"}));
    try {
        to_display(one_pixel(1), "filmc");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.fault(), Fault::usage);
        EXPECT_NE(std::string(error.what()).find("did you mean filmic?"), std::string::npos);
        EXPECT_NE(std::string(error.what()).find("standard"), std::string::npos);
    }
}

TEST(Color, EnvironmentConfigurationIsUsedOrReported) {
    const test::Folder folder;
    const std::string path = folder.file("config.ocio");
    setenv("OCIO", path.c_str(), 1);
    EXPECT_THROW(view_names(), Error);
    write_file(path, R"(ocio_profile_version: 2
roles:
  default: lin
  scene_linear: lin
file_rules:
  - !<Rule> {name: Default, colorspace: default}
displays:
  screen:
    - !<View> {name: half, colorspace: half}
colorspaces:
  - !<ColorSpace>
    name: lin
  - !<ColorSpace>
    name: half
    from_scene_reference: !<MatrixTransform> {matrix: [0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 1]}
)");
    EXPECT_EQ(view_names(), std::vector<std::string>{"half"});
    EXPECT_FLOAT_EQ(to_display(one_pixel(0.5F)).pixels[0], 0.25F);
    unsetenv("OCIO");
}

} // namespace
} // namespace scree
