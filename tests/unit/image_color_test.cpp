// SPDX-License-Identifier: GPL-3.0-or-later
// What PNG, JPEG and HDR files say of their colours and of how they are held, against values by the
// formulas of their specifications.
#include "core/image.h"
#include "tests/support/errors.h"
#include "tests/support/image_bytes.h"
#include "tests/support/pictures.h"

#include <gtest/gtest.h>

#include <cmath>

namespace scree {
namespace {

using namespace test;
using tests::error_of;

using Pixel = std::vector<double>;

double srgb(double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); }

std::string bytes(std::initializer_list<int> values) {
    std::string out;
    for (const int value : values)
        out += static_cast<char>(value);
    return out;
}

void expect_pixel(const Image& image, int x, int y, const Pixel& want, const std::string& what,
                  double tolerance = 2e-5) {
    ASSERT_EQ(image.channels.size(), want.size()) << what;
    for (std::size_t c = 0; c < want.size(); ++c)
        EXPECT_NEAR(image.at(x, y)[c], want[c], tolerance) << what << ", channel " << c;
}

// IEC 61966-2-1 and SMPTE EG 432-1, with D65: linear Rec. 709 from Display P3, as published (CSS
// Color 4, section 18).
Pixel from_p3(double r, double g, double b) {
    return {1.2249402 * r - 0.2249402 * g, -0.0420570 * r + 1.0420570 * g,
            -0.0196376 * r - 0.0786361 * g + 1.0982736 * b};
}

const std::string p3_chrm = [] {
    std::string data;
    for (const std::uint32_t v : {31270, 32900, 68000, 32000, 26500, 69000, 15000, 6000})
        data += big_endian(v, 4);
    return png_chunk("cHRM", data);
}();

std::string gamma_chunk(std::uint32_t value) { return png_chunk("gAMA", big_endian(value, 4)); }

std::string curve(std::initializer_list<std::uint32_t> values) {
    std::string out =
        std::string("curv\0\0\0\0", 8) + big_endian(static_cast<std::uint32_t>(values.size()), 4);
    for (const std::uint32_t value : values)
        out += big_endian(value, 2);
    return out;
}

std::string parametric(std::uint32_t kind, std::initializer_list<double> values) {
    std::string out = std::string("para\0\0\0\0", 8) + big_endian(kind, 2) + std::string(2, '\0');
    for (const double value : values)
        out += icc_fixed(value);
    return out;
}

/// Colorants relative to D50, as in the profiles of the International Color Consortium.
std::string rgb_profile(const std::string& tone, bool p3) {
    return p3 ? icc_bytes("RGB ", {{"rXYZ", icc_xyz(0.51512, 0.24120, -0.00105)},
                                   {"gXYZ", icc_xyz(0.29198, 0.69225, 0.04189)},
                                   {"bXYZ", icc_xyz(0.15710, 0.06657, 0.78407)},
                                   {"rTRC", tone},
                                   {"gTRC", tone},
                                   {"bTRC", tone}})
              : icc_bytes("RGB ", {{"rXYZ", icc_xyz(0.43607, 0.22249, 0.01392)},
                                   {"gXYZ", icc_xyz(0.38515, 0.71687, 0.09708)},
                                   {"bXYZ", icc_xyz(0.14307, 0.06061, 0.71410)},
                                   {"rTRC", tone},
                                   {"gTRC", tone},
                                   {"bTRC", tone}});
}

std::string profile_chunk(const std::string& profile) {
    return png_chunk("iCCP", std::string("profile\0\0", 9) + stored(profile));
}

TEST(PngColor, StoredValuesBecomeLinearRec709) {
    struct Case {
        const char* name;
        int depth;
        int type;
        std::string row; // of one pixel
        std::string chunks;
        Pixel want;
        double tolerance = 2e-5;
    };
    const std::string rgb = bytes({128, 64, 32});
    const auto v = [](int i) { return i / 255.0; };
    const Pixel as_srgb{srgb(v(128)), srgb(v(64)), srgb(v(32))};
    const Pixel stays{v(128), v(64), v(32)};
    const Pixel p3 = from_p3(v(128), v(64), v(32));
    const std::string srgb_curve =
        parametric(3, {2.4, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045});
    const std::vector<Case> cases{
        {"grey", 8, 0, bytes({188}), "", {srgb(v(188))}},
        {"one bit", 1, 0, bytes({0x80}), "", {1}},
        {"two bits", 2, 0, bytes({0x40}), "", {srgb(1 / 3.0)}},
        {"four bits", 4, 0, bytes({0x50}), "", {srgb(5 / 15.0)}},
        {"grey and alpha", 8, 4, bytes({188, 51}), "", {0.2 * srgb(v(188)), 0.2}},
        {"RGB", 8, 2, rgb, "", as_srgb},
        {"RGB and alpha",
         8,
         6,
         bytes({128, 64, 32, 102}),
         "",
         {0.4 * as_srgb[0], 0.4 * as_srgb[1], 0.4 * as_srgb[2], 0.4}},
        {"16 bits",
         16,
         2,
         bytes({0x80, 0x01, 0x40, 0x02, 0xff, 0xff}),
         "",
         {srgb(0x8001 / 65535.0), srgb(0x4002 / 65535.0), 1}},
        {"palette", 8, 3, bytes({1}), png_chunk("PLTE", bytes({9, 9, 9, 128, 64, 32})), as_srgb},
        {"palette with alpha",
         8,
         3,
         bytes({1}),
         png_chunk("PLTE", bytes({9, 9, 9, 128, 64, 32})) + png_chunk("tRNS", bytes({0, 51})),
         {0.2 * as_srgb[0], 0.2 * as_srgb[1], 0.2 * as_srgb[2], 0.2}},
        {"one transparent colour",
         8,
         2,
         rgb,
         png_chunk("tRNS", bytes({0, 128, 0, 64, 0, 32})),
         {0, 0, 0, 0}},
        {"gAMA of 1", 8, 2, rgb, gamma_chunk(100000), stays},
        {"gAMA of 1/1.8",
         8,
         2,
         rgb,
         gamma_chunk(55556),
         {std::pow(v(128), 1.8), std::pow(v(64), 1.8), std::pow(v(32), 1.8)}},
        {"gAMA of 1/2.2", 8, 2, rgb, gamma_chunk(45455), as_srgb},
        {"sRGB before gAMA", 8, 2, rgb, png_chunk("sRGB", bytes({0})) + gamma_chunk(100000),
         as_srgb},
        {"gAMA with alpha",
         8,
         6,
         bytes({128, 64, 32, 102}),
         gamma_chunk(100000),
         {0.4 * v(128), 0.4 * v(64), 0.4 * v(32), 0.4}},
        {"cHRM", 8, 2, rgb, gamma_chunk(100000) + p3_chrm, p3, 2e-4},
        {"cICP before all", 8, 2, rgb,
         png_chunk("cICP", bytes({12, 8, 0, 1})) + png_chunk("sRGB", bytes({0})), p3, 2e-4},
        {"profile of sRGB", 8, 2, rgb, profile_chunk(rgb_profile(srgb_curve, false)), as_srgb},
        {"profile before gAMA", 8, 2, rgb,
         profile_chunk(rgb_profile(srgb_curve, false)) + gamma_chunk(100000), as_srgb},
        {"linear profile", 8, 2, rgb, profile_chunk(rgb_profile(curve({}), true)), p3, 5e-4},
        {"profile with a power", 8, 2, rgb, profile_chunk(rgb_profile(curve({0x0200}), true)),
         from_p3(v(128) * v(128), v(64) * v(64), v(32) * v(32)), 5e-4},
        // A table through 0, 1/4 and 1 at 0, 1/2 and 1.
        {"profile with a table", 8, 2, rgb,
         profile_chunk(rgb_profile(curve({0, 0x4000, 0xffff}), true)),
         from_p3(0.25 + (v(128) - 0.5) * 1.5, v(64) / 2, v(32) / 2), 5e-4},
        {"profile with an offset", 8, 2, rgb,
         profile_chunk(rgb_profile(parametric(1, {1, 2, -0.125}), true)),
         from_p3(2 * v(128) - 0.125, 2 * v(64) - 0.125, 2 * v(32) - 0.125), 5e-4},
        {"profile of grey",
         8,
         0,
         bytes({128}),
         profile_chunk(icc_bytes("GRAY", {{"kTRC", curve({0x0100})}})),
         {v(128)}},
    };
    const Folder folder;
    for (const Case& tested : cases) {
        const std::string path = folder.write(
            "a.png", png_bytes_of(1, tested.depth, tested.type, {tested.row}, tested.chunks));
        std::string warnings;
        const Image image =
            read_image(path, {.warn = [&](const std::string& text) { warnings += text; }});
        expect_pixel(image, 0, 0, tested.want, tested.name, tested.tolerance);
        EXPECT_EQ(warnings, "") << tested.name;
    }
}

TEST(PngColor, DataStayAsStored) {
    const Folder folder;
    const std::string path = folder.write(
        "a.png", png_bytes_of(1, 8, 6, {bytes({128, 64, 32, 102})}, gamma_chunk(100000) + p3_chrm));
    expect_pixel(read_data_image(path), 0, 0, {128 / 255.0, 64 / 255.0, 32 / 255.0, 0.4}, "data");
}

TEST(PngColor, WhatCannotBeConvertedIsRefused) {
    const Folder folder;
    const auto message = [&](const std::string& chunks) {
        const std::string path =
            folder.write("a.png", png_bytes_of(1, 8, 2, {bytes({1, 2, 3})}, chunks));
        const std::string text = error_of([&] { read_image(path); });
        return text.substr(std::min(text.size(), path.size() + 2));
    };
    EXPECT_EQ(message(profile_chunk(icc_bytes("RGB ", {{"A2B0", "mft2"}}))),
              "its embedded profile consists of lookup tables, which are not read; convert it to "
              "sRGB");
    EXPECT_EQ(message(profile_chunk(rgb_profile("text", true))), "its embedded profile is damaged");
    EXPECT_EQ(message(png_chunk("cICP", bytes({9, 16, 0, 1}))),
              "its cICP has the transfer function 16, which is not read; convert it to sRGB");
    EXPECT_EQ(message(png_chunk("cICP", bytes({4, 8, 0, 1}))),
              "its cICP has the primaries 4, which are not read; convert it to sRGB");
    EXPECT_EQ(message(png_chunk("cHRM", std::string(32, '\0'))),
              "its chromaticities are impossible: y must be above 0");
}

/// Where the black half of the JPEG lies, as each orientation of EXIF (4.6.4) shows it.
TEST(ImageOrientation, AllEightAreTurnedUpright) {
    struct Case {
        int orientation;
        bool upright;     // 16 x 8, else 8 x 16
        bool black_first; // the black half lies left, or on top
    };
    const Folder folder;
    for (const auto& [orientation, is_upright, black_first] :
         std::vector<Case>{{1, true, true},
                           {2, true, false},
                           {3, true, false},
                           {4, true, true},
                           {5, false, true},
                           {6, false, true},
                           {7, false, false},
                           {8, false, false}}) {
        const std::string path = folder.write(
            "a.jpg",
            jpeg_bytes(jpeg_segment(0xe1, std::string("Exif\0\0", 6) + exif_bytes(orientation))));
        for (const Image& image : {read_image(path), read_data_image(path)}) {
            ASSERT_EQ(image.width, is_upright ? 16 : 8) << orientation;
            ASSERT_EQ(image.height, is_upright ? 8 : 16) << orientation;
            EXPECT_NEAR(image.at(0, 0)[0], black_first ? 0 : 1, 1e-5) << orientation;
            EXPECT_NEAR(image.at(image.width - 1, image.height - 1)[0], black_first ? 1 : 0, 1e-5)
                << orientation;
        }
    }
    // 2 x 3 pixels 0 to 5 by rows; where 0 and 1 are seen follows from rows and columns that begin
    // at the top left, top right, bottom right, bottom left, left top, right top, right bottom and
    // left bottom.
    const int places[8][4] = {{0, 0, 1, 0}, {1, 0, 0, 0}, {1, 2, 0, 2}, {0, 2, 1, 2},
                              {0, 0, 0, 1}, {2, 0, 2, 1}, {2, 1, 2, 0}, {0, 1, 0, 0}};
    for (int orientation = 1; orientation <= 8; ++orientation) {
        const std::string path = folder.write(
            "a.png", png_bytes_of(2, 8, 0, {bytes({0, 1}), bytes({2, 3}), bytes({4, 5})},
                                  png_chunk("eXIf", exif_bytes(orientation))));
        const Image image = read_data_image(path);
        const int* place = places[orientation - 1];
        EXPECT_NEAR(image.at(place[0], place[1])[0] * 255, 0, 1e-4) << orientation;
        EXPECT_NEAR(image.at(place[2], place[3])[0] * 255, 1, 1e-4) << orientation;
    }
}

TEST(Jpeg, ProfilesAreReadAndCmykIsRefused) {
    const Folder folder;
    const std::string profile =
        std::string("ICC_PROFILE\0\x01\x01", 14) + icc_bytes("CMYK", {{"A2B0", "mft2"}});
    const std::string other = folder.write("a.jpg", jpeg_bytes(jpeg_segment(0xe2, profile)));
    EXPECT_EQ(error_of([&] { read_image(other); }),
              other +
                  ": its embedded profile is of CMYK, expected RGB or GRAY; convert it to sRGB");
    EXPECT_EQ(read_data_image(other).width, 16);
    std::string cmyk = jpeg_bytes();
    cmyk[cmyk.find("\xff\xc0") + 9] = 4;
    const std::string path = folder.write("cmyk.jpg", cmyk);
    EXPECT_EQ(error_of([&] { read_image(path); }),
              path + ": is of CMYK, which is not read; convert it to RGB");
}

std::string hdr(const std::string& lines, const std::string& size, const std::string& pixels) {
    return "#?RADIANCE\n" + lines + "\n" + size + "\n" + pixels;
}

const std::string rgbe = "FORMAT=32-bit_rle_rgbe\n";

TEST(Hdr, AllOrdersOfPixels) {
    // 2 x 3 pixels 0 to 5, as mantissas of 1/128. X goes right, Y up; the first axis is the slower.
    struct Case {
        const char* size;
        int first[2], second[2]; // where pixels 0 and 1 are seen
    };
    std::string pixels;
    for (int i = 0; i < 6; ++i)
        pixels += bytes({i, 10 * i, 0, 129});
    const Folder folder;
    for (const auto& [size, first, second] : std::vector<Case>{{"-Y 3 +X 2", {0, 0}, {1, 0}},
                                                               {"-Y 3 -X 2", {1, 0}, {0, 0}},
                                                               {"+Y 3 -X 2", {1, 2}, {0, 2}},
                                                               {"+Y 3 +X 2", {0, 2}, {1, 2}},
                                                               {"+X 3 -Y 2", {0, 0}, {0, 1}},
                                                               {"-X 3 -Y 2", {2, 0}, {2, 1}},
                                                               {"-X 3 +Y 2", {2, 1}, {2, 0}},
                                                               {"+X 3 +Y 2", {0, 1}, {0, 0}}}) {
        const Image image = read_image(folder.write("a.hdr", hdr(rgbe, size, pixels)));
        ASSERT_EQ(image.width, size[1] == 'Y' ? 2 : 3) << size;
        expect_pixel(image, first[0], first[1], {0, 0, 0}, size);
        expect_pixel(image, second[0], second[1], {1 / 128.0, 10 / 128.0, 0}, size);
    }
}

TEST(Hdr, HeadersSayWhatTheNumbersMean) {
    struct Case {
        const char* name;
        std::string lines;
        Pixel want;
        double tolerance = 2e-5;
    };
    const Folder folder;
    const Pixel p3 = from_p3(1, 0.5, 0.25);
    for (const auto& [name, lines, want, tolerance] : std::vector<Case>{
             {"plain", rgbe, {1, 0.5, 0.25}},
             {"no format", "SOFTWARE=x\n", {1, 0.5, 0.25}},
             {"exposures", "EXPOSURE=2\n" + rgbe + "EXPOSURE= 4\n", {1 / 8.0, 0.5 / 8, 0.25 / 8}},
             {"colour corrections", rgbe + "COLORCORR= 2 1 0.5\n", {0.5, 0.5, 0.5}},
             {"primaries", rgbe + "PRIMARIES=0.68 0.32 0.265 0.69 0.15 0.06 0.3127 0.329\n", p3,
              2e-4}})
        expect_pixel(
            read_image(folder.write("a.hdr", hdr(lines, "-Y 1 +X 1", bytes({128, 64, 32, 129})))),
            0, 0, want, name, tolerance);
    // Equal X, Y and Z are the white on which they are based.
    const Image white = read_image(folder.write(
        "a.hdr", hdr("FORMAT=32-bit_rle_xyze\n", "-Y 1 +X 1", bytes({128, 128, 128, 129}))));
    expect_pixel(white, 0, 0, {1, 1, 1}, "XYZ", 1e-4);
}

TEST(Hdr, RunsAreRead) {
    const Folder folder;
    // By component: 10 pixels, red a run of 10, green 10 bytes, blue and exponent runs.
    std::string coded = bytes({2, 2, 0, 10, 138, 128, 10});
    for (int i = 0; i < 10; ++i)
        coded += static_cast<char>(10 * i);
    coded += bytes({138, 0, 138, 129});
    const Image runs = read_image(folder.write("a.hdr", hdr(rgbe, "-Y 1 +X 10", coded)));
    for (int x = 0; x < 10; ++x)
        expect_pixel(runs, x, 0, {1, 10 * x / 128.0, 0}, "by component");
    // By the old rule: one pixel and 3 + 1 * 256 like it, then another.
    const Image old = read_image(folder.write(
        "a.hdr",
        hdr(rgbe, "-Y 1 +X 261", bytes({128, 0, 0, 129, 1, 1, 1, 3, 1, 1, 1, 1, 0, 128, 0, 129}))));
    expect_pixel(old, 0, 0, {1, 0, 0}, "old");
    expect_pixel(old, 259, 0, {1, 0, 0}, "old");
    expect_pixel(old, 260, 0, {0, 1, 0}, "old");
}

TEST(Hdr, MistakesAreNamed) {
    const Folder folder;
    const auto message = [&](const std::string& lines, const std::string& size,
                             const std::string& pixels) {
        const std::string path = folder.write("a.hdr", hdr(lines, size, pixels));
        const std::string text = error_of([&] { read_image(path); });
        return text.substr(std::min(text.size(), path.size() + 2));
    };
    const std::string pixel = bytes({128, 64, 32, 129});
    EXPECT_EQ(message("FORMAT=float\n", "-Y 1 +X 1", pixel),
              "FORMAT: expected 32-bit_rle_rgbe or 32-bit_rle_xyze, got \"float\"");
    EXPECT_EQ(message("EXPOSURE=0\n", "-Y 1 +X 1", pixel),
              "EXPOSURE: expected a number above 0, got \"0\"");
    EXPECT_EQ(message("PRIMARIES=1 2\n", "-Y 1 +X 1", pixel),
              "PRIMARIES: expected 8 numbers, got \"1 2\"");
    EXPECT_EQ(message(rgbe, "1 x 1", pixel),
              "expected a size like \"-Y 512 +X 1024\", got \"1 x 1\"");
    EXPECT_EQ(message(rgbe, "-Y 2 +X 2", pixel + pixel + pixel),
              "is not a valid HDR image: it ends before its last pixel");
    EXPECT_EQ(message(rgbe, "-Y 1 +X 8", bytes({2, 2, 0, 8, 137, 1})),
              "is not a valid HDR image: a run does not fit its line");
    EXPECT_EQ(message(rgbe, "-Y 70000 +X 1", pixel), "is too large: 1 x 70000 with 3 channels");
    const std::string cut = folder.write("b.hdr", "#?RADIANCE\nFORMAT");
    EXPECT_EQ(error_of([&] { read_image(cut); }),
              cut + ": is not a valid HDR image: its header does not end");
}

} // namespace
} // namespace scree
