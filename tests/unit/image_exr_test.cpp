// SPDX-License-Identifier: GPL-3.0-or-later
// Layers, windows and colours of EXR files that other programs write.
#include "core/image.h"
#include "tests/support/errors.h"
#include "tests/support/image_bytes.h"
#include "tests/support/pictures.h"

#include <gtest/gtest.h>

#include <limits>

namespace scree {
namespace {

using namespace test;
using tests::error_of;

using Channels = std::map<std::string, ExrChannel>;

/// 2 x 1 pixels; each channel has the value given in all of them.
std::string flat_exr(const std::vector<std::pair<std::string, float>>& values,
                     const std::string& attributes = {}) {
    Channels channels;
    for (const auto& [name, value] : values)
        channels[name] = constant(2, 1, value);
    return exr_bytes(channels, {0, 0, 1, 0}, {0, 0, 1, 0}, attributes);
}

std::vector<float> first_pixel(const Image& image) {
    return {image.pixels.begin(),
            image.pixels.begin() + static_cast<std::ptrdiff_t>(image.channels.size())};
}

TEST(ExrLayers, ThePictureIsFoundByName) {
    struct Case {
        const char* name;
        std::vector<std::pair<std::string, float>> channels;
        std::string layer;
        std::vector<std::string> want_channels;
        std::vector<float> want;
    };
    const std::vector<std::string> rgb{"R", "G", "B"}, rgba{"R", "G", "B", "A"};
    const std::vector<float> values{0.75F, 0.5F, 0.25F}, with_alpha{0.75F, 0.5F, 0.25F, 1};
    const Folder folder;
    for (const Case& tested : std::vector<Case>{
             {"plain", {{"R", .75F}, {"G", .5F}, {"B", .25F}}, "", rgb, values},
             {"a layer",
              {{"rgba.R", .75F}, {"rgba.G", .5F}, {"rgba.B", .25F}, {"rgba.A", 1}},
              "",
              rgba,
              with_alpha},
             {"layers in layers",
              {{"ViewLayer.Combined.A", 1},
               {"ViewLayer.Combined.B", .25F},
               {"ViewLayer.Combined.G", .5F},
               {"ViewLayer.Combined.R", .75F},
               {"ViewLayer.Depth.Z", 9},
               {"ViewLayer.DiffCol.R", 7},
               {"ViewLayer.DiffCol.G", 7},
               {"ViewLayer.DiffCol.B", 7}},
              "",
              rgba,
              with_alpha},
             {"small letters", {{"r", .75F}, {"g", .5F}, {"b", .25F}}, "", rgb, values},
             {"whole words",
              {{"Beauty.red", .75F},
               {"Beauty.green", .5F},
               {"Beauty.blue", .25F},
               {"Beauty.alpha", 1}},
              "",
              rgba,
              with_alpha},
             {"beside layers and depth",
              {{"R", .75F},
               {"G", .5F},
               {"B", .25F},
               {"Z", 9},
               {"albedo.R", 7},
               {"albedo.G", 7},
               {"albedo.B", 7}},
              "",
              rgb,
              values},
             {"grey", {{"Y", .5F}}, "", {"Y"}, {.5F}},
             {"grey and alpha", {{"Y", .5F}, {"A", 1}}, "", {"Y", "A"}, {.5F, 1}},
             {"grey of a layer", {{"mono.y", .5F}, {"mono.a", 1}}, "", {"Y", "A"}, {.5F, 1}},
             {"beside a position",
              {{"P.X", 1}, {"P.Y", 2}, {"P.Z", 3}, {"x.R", .75F}, {"x.G", .5F}, {"x.B", .25F}},
              "",
              rgb,
              values},
             {"a layer by name",
              {{"R", 7},
               {"G", 7},
               {"B", 7},
               {"albedo.R", .75F},
               {"albedo.G", .5F},
               {"albedo.B", .25F}},
              "albedo",
              rgb,
              values},
             {"by the end of its name",
              {{"R", 7},
               {"G", 7},
               {"B", 7},
               {"View.DiffCol.R", .75F},
               {"View.DiffCol.G", .5F},
               {"View.DiffCol.B", .25F}},
              "diffcol",
              rgb,
              values}}) {
        const Image image =
            read_image(folder.write("a.exr", flat_exr(tested.channels)), {.layer = tested.layer});
        EXPECT_EQ(image.channels, tested.want_channels) << tested.name;
        EXPECT_EQ(first_pixel(image), tested.want) << tested.name;
    }
}

TEST(ExrLayers, PartsAreLayers) {
    const Folder folder;
    const auto part = [](const std::string& name, std::vector<std::string> channels, float value) {
        Image image(2, 1, std::move(channels));
        std::fill(image.pixels.begin(), image.pixels.end(), value);
        return ImagePart{name, std::move(image), true};
    };
    const std::vector<ImagePart> parts{part("depth", {"Z"}, 9), part("normal", {"R", "G", "B"}, 7),
                                       part("view.beauty", {"R", "G", "B"}, 0.5F)};
    const std::string path = folder.file("a.exr");
    write_exr(path, parts, {});
    EXPECT_EQ(first_pixel(read_image(path)), std::vector<float>(3, 0.5F));
    EXPECT_EQ(first_pixel(read_image(path, {.layer = "normal"})), std::vector<float>(3, 7.0F));
    EXPECT_EQ(first_pixel(read_image(path, {.layer = "beauty"})), std::vector<float>(3, 0.5F));
}

TEST(ExrLayers, WhatIsNoPictureIsNamed) {
    const Folder folder;
    const auto message = [&](const std::vector<std::pair<std::string, float>>& channels,
                             const std::string& layer = {}) {
        const std::string path = folder.write("a.exr", flat_exr(channels));
        const std::string text = error_of([&] { read_image(path, {.layer = layer}); });
        return text.substr(std::min(text.size(), path.size() + 2));
    };
    EXPECT_EQ(message({{"A", 1}, {"Z", 3}}),
              "is no picture: it has neither R, G and B nor Y; its channels are: A, Z");
    EXPECT_EQ(message({{"P.X", 1}, {"P.Y", 2}, {"P.Z", 3}}),
              "is no picture: it has neither R, G and B nor Y; its channels are: P.X, P.Y, P.Z");
    const std::vector<std::pair<std::string, float>> two{{"diffuse.R", 1}, {"diffuse.G", 1},
                                                         {"diffuse.B", 1}, {"gloss.R", 1},
                                                         {"gloss.G", 1},   {"gloss.B", 1}};
    EXPECT_EQ(message(two),
              "holds several pictures: diffuse, gloss\n  name one with layer = \"diffuse\"");
    EXPECT_EQ(message(two, "difuse"),
              "has no layer \"difuse\"; its layers are: diffuse, gloss\n  did you mean diffuse?");
    const std::string png = folder.write("a.png", png_bytes_of(1, 8, 0, {"a"}));
    EXPECT_EQ(error_of([&] { read_image(png, {.layer = "b"}); }),
              png + ": has no layer \"b\"; only EXR has layers");
}

TEST(ExrLayers, DataKeepTheirChannels) {
    const Folder folder;
    const auto channels = [&](const std::vector<std::pair<std::string, float>>& values) {
        return read_data_image(folder.write("a.exr", flat_exr(values))).channels;
    };
    using Names = std::vector<std::string>;
    EXPECT_EQ(channels({{"A", 1}, {"Z", 3}}), Names{"A"});
    EXPECT_EQ(channels({{"mask.R", 1}}), Names{"R"});
    EXPECT_EQ(channels({{"Z", 3}}), Names{"Z"});
    EXPECT_EQ(channels({{"rgba.R", 1}, {"rgba.G", 1}, {"rgba.B", 1}, {"rgba.A", 1}}),
              (Names{"R", "G", "B", "A"}));
}

TEST(ExrWindows, ThePictureIsTheDisplayWindow) {
    // Pixel (x, y) holds 1 + x + 10 y wherever the data window has it.
    struct Case {
        const char* name;
        ExrWindow data, display;
    };
    const Folder folder;
    for (const auto& [name, data, display] :
         std::vector<Case>{{"the same", {0, 0, 3, 2}, {0, 0, 3, 2}},
                           {"inside", {1, 1, 2, 1}, {0, 0, 3, 2}},
                           {"beyond", {-2, -1, 5, 4}, {0, 0, 3, 2}},
                           {"across", {2, -1, 6, 1}, {0, 0, 3, 2}},
                           {"not at the origin", {10, 20, 13, 22}, {10, 20, 13, 22}},
                           {"of negative places", {-4, -3, -2, -1}, {-5, -3, -1, 0}},
                           {"apart", {8, 8, 9, 9}, {0, 0, 3, 2}}}) {
        ExrChannel channel;
        for (int y = data.y0; y <= data.y1; ++y) {
            channel.rows.emplace_back();
            for (int x = data.x0; x <= data.x1; ++x)
                channel.rows.back().push_back(static_cast<float>(1 + x + 10 * y) + 100);
        }
        const std::string path = folder.write(
            "a.exr", exr_bytes({{"R", channel}, {"G", channel}, {"B", channel}}, data, display));
        std::string warnings;
        const Image image =
            read_image(path, {.warn = [&](const std::string& text) { warnings += text; }});
        ASSERT_EQ(image.width, display.x1 - display.x0 + 1) << name;
        ASSERT_EQ(image.height, display.y1 - display.y0 + 1) << name;
        for (int y = display.y0; y <= display.y1; ++y)
            for (int x = display.x0; x <= display.x1; ++x) {
                const bool in = x >= data.x0 && x <= data.x1 && y >= data.y0 && y <= data.y1;
                EXPECT_EQ(image.at(x - display.x0, y - display.y0)[1],
                          in ? static_cast<float>(101 + x + 10 * y) : 0.0F)
                    << name << " " << x << " " << y;
            }
        EXPECT_EQ(warnings, std::string(name) == "apart"
                                ? path + ": its data window lies outside its "
                                         "display window, so that it is black"
                                : "");
        EXPECT_EQ(read_data_image(path).pixels, image.pixels) << name;
    }
}

TEST(ExrColor, ChromaticitiesBecomeRec709) {
    const auto attribute = [](std::initializer_list<float> xy) {
        std::string data;
        for (const float v : xy)
            data += little_endian(v);
        return exr_attribute("chromaticities", "chromaticities", data);
    };
    struct Case {
        const char* name;
        std::string attributes;
        std::vector<float> want; // of 0.5, 0.25, 0.125
    };
    const Folder folder;
    const float r = 0.5F, g = 0.25F, b = 0.125F;
    for (const auto& [name, attributes, want] : std::vector<Case>{
             {"Rec. 709",
              attribute({0.64F, 0.33F, 0.3F, 0.6F, 0.15F, 0.06F, 0.3127F, 0.329F}),
              {r, g, b}},
             // ITU-R BT.2087, section 4, backwards.
             {"Rec. 2020",
              attribute({0.708F, 0.292F, 0.17F, 0.797F, 0.131F, 0.046F, 0.3127F, 0.329F}),
              {1.6605F * r - 0.5876F * g - 0.0728F * b, -0.1246F * r + 1.1329F * g - 0.0083F * b,
               -0.0182F * r - 0.1006F * g + 1.1187F * b}},
             // ACES 1.3, ACEScg to Rec. 709 with Bradford's adaptation from its white.
             {"ACEScg",
              attribute({0.713F, 0.293F, 0.165F, 0.83F, 0.128F, 0.044F, 0.32168F, 0.33767F}),
              {1.70505F * r - 0.62179F * g - 0.08326F * b,
               -0.13026F * r + 1.14080F * g - 0.01055F * b,
               -0.02400F * r - 0.12897F * g + 1.15297F * b}}}) {
        const std::string path =
            folder.write("a.exr", flat_exr({{"R", r}, {"G", g}, {"B", b}}, attributes));
        const std::vector<float> got = first_pixel(read_image(path));
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(got[c], want[c], 2e-4) << name << " " << c;
        EXPECT_EQ(first_pixel(read_data_image(path)), (std::vector<float>{r, g, b})) << name;
    }
}

TEST(ExrColor, LuminanceAndChromaBecomeColours) {
    // RY = (R - Y) / Y, BY = (B - Y) / Y, and Y by the weights of Rec. 709.
    const Folder folder;
    const std::string path = folder.write("a.exr", exr_bytes({{"Y", constant(64, 64, 0.5F)},
                                                              {"RY", constant(64, 64, 0.2F, 2)},
                                                              {"BY", constant(64, 64, -0.1F, 2)}},
                                                             {0, 0, 63, 63}, {0, 0, 63, 63}));
    const Image image = read_image(path);
    ASSERT_EQ(image.channels, (std::vector<std::string>{"R", "G", "B"}));
    const float* pixel = image.at(32, 32);
    EXPECT_NEAR(pixel[0], 0.6, 2e-3);
    EXPECT_NEAR(pixel[1], (0.5 - 0.2126 * 0.6 - 0.0722 * 0.45) / 0.7152, 2e-3);
    EXPECT_NEAR(pixel[2], 0.45, 2e-3);
}

TEST(ExrPixels, OddOnesAreToldAndMended) {
    const Folder folder;
    const auto read = [&](const Channels& channels, std::string& said, float aspect = 1) {
        const std::string path =
            folder.write("a.exr", exr_bytes(channels, {0, 0, 1, 1}, {0, 0, 1, 1}, {}, aspect));
        Image image;
        said.clear();
        said = error_of([&] {
            image = read_image(path, {.warn = [&](const std::string& text) { said += text; }});
            throw Error("warned: " + said);
        });
        for (std::size_t at = 0; (at = said.find(path)) != std::string::npos;)
            said.replace(at, path.size(), "a.exr");
        return image;
    };
    std::string said;
    const ExrChannel half = constant(2, 2, 0.5F);
    const Image dark =
        read({{"R", {{{0.5F, -1.0F}, {-0.25F, 0.5F}}}}, {"G", half}, {"B", half}}, said);
    EXPECT_EQ(said, "warned: a.exr: 2 pixels, the first at (1, 0), are negative and taken as 0");
    EXPECT_EQ(dark.at(1, 0)[0], 0.0F);
    EXPECT_EQ(dark.at(1, 0)[1], 0.5F);
    const Image solid =
        read({{"R", half}, {"G", half}, {"B", half}, {"A", {{{1, 2}, {1, 1}}}}}, said);
    EXPECT_EQ(said, "warned: a.exr: pixel (1, 0) is outside 0 to 1 in alpha and brought to its "
                    "nearer end");
    EXPECT_EQ(solid.at(1, 0)[3], 1.0F);
    for (const float odd :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        read({{"R", half}, {"G", {{{0.5F, 0.5F}, {odd, 0.5F}}}}, {"B", half}}, said);
        EXPECT_EQ(said, "a.exr: pixel (0, 1) is not finite");
    }
    read({{"R", half}, {"G", half}, {"B", half}}, said, 2);
    EXPECT_EQ(said, "warned: a.exr: its pixels are 2 times as wide as high; they are taken as "
                    "squares");
    read({{"R", half}, {"G", half}, {"B", constant(2, 2, 0.5F, 2)}}, said);
    EXPECT_EQ(said, "a.exr: the channel B holds one value for 2 x 2 pixels, which is read beside "
                    "a luminance only (Y, RY, BY)");
}

TEST(ExrPixels, CubeMapsAreRefused) {
    const Folder folder;
    const std::string path =
        folder.write("a.exr", flat_exr({{"R", 1}, {"G", 1}, {"B", 1}},
                                       exr_attribute("envmap", "envmap", std::string(1, '\x01'))));
    EXPECT_EQ(error_of([&] { read_image(path); }),
              path + ": holds a cube map, which is not read; convert it to latitude and longitude");
}

} // namespace
} // namespace scree
