// SPDX-License-Identifier: GPL-3.0-or-later
// Reading of pictures, and rejection of invalid ones.
#include "core/base64.h"
#include "core/display_encoding.h"
#include "core/drawing.h"
#include "core/drawing_raster.h"
#include "core/embedded_picture.h"
#include "tests/support/pictures.h"

#include <gtest/gtest.h>

namespace scree {
namespace {

using test::error_of;
using test::svg;

std::string refusal(const std::string& body,
                    const std::string& attributes = "width='40' height='20'") {
    return error_of([&] { read_drawing(svg(body, attributes)); });
}

TEST(Picture, PixelsBecomeLinearAndPremultiplied) {
    const test::Folder folder;
    Image stored(4, 2, {"R", "G", "B", "A"});
    for (std::size_t i = 0; i < stored.pixels.size(); i += 4) {
        stored.pixels[i] = 1;
        stored.pixels[i + 1] = 188 / 255.0F; // 0.5 in linear light
        stored.pixels[i + 3] = 51 / 255.0F;
    }
    write_png(folder.file("a.png"), stored);
    const Picture picture = read_picture(folder.file("a.png"));
    EXPECT_EQ(picture.name, "a.png");
    EXPECT_TRUE(picture.drawing.empty());
    EXPECT_EQ(picture.box.size(), Vec2(1, 0.5));
    const float* pixel = picture.image.at(3, 1);
    EXPECT_NEAR(pixel[0], 0.2F, 1e-5);
    EXPECT_NEAR(pixel[1], 0.2F * 0.5029F, 1e-4);
    EXPECT_EQ(pixel[2], 0.0F);
    EXPECT_NEAR(pixel[3], 0.2F, 1e-5);
    // The conversion back gives the same 8 bits.
    const Image display = display_image(picture.image);
    for (std::size_t i = 0; i < display.pixels.size(); ++i)
        EXPECT_NEAR(display.pixels[i], stored.pixels[i], 1e-5);
}

TEST(Picture, GreyHasThreeEqualChannelsAndIsOpaque) {
    const test::Folder folder;
    Image grey(3, 3, {"Y"});
    for (float& v : grey.pixels)
        v = 1;
    write_png(folder.file("grey.png"), grey);
    EXPECT_EQ(read_picture(folder.file("grey.png")).image.pixels, std::vector<float>(36, 1.0F));
}

TEST(Picture, DrawingsAreRasterisedWithTheirAlpha) {
    const test::Folder folder;
    const std::string path = folder.write(
        "half.svg", svg("<rect x='20' width='20' height='20' fill='#bcbcbc' opacity='0.5'/>"));
    const Picture picture = read_picture(path, 100);
    EXPECT_EQ(picture.image.width, 100);
    EXPECT_EQ(picture.image.height, 50);
    EXPECT_EQ(picture.box.size(), Vec2(1, 0.5));
    EXPECT_EQ(picture.image.at(20, 25)[3], 0.0F);
    EXPECT_NEAR(picture.image.at(80, 25)[3], 0.5F, 0.004);
    EXPECT_NEAR(picture.image.at(80, 25)[0], 0.25F, 0.006);
    EXPECT_EQ(read_drawing(svg("", "viewBox='0 0 3 7'")).size, Vec2(3, 7));
    EXPECT_EQ(read_drawing(svg("", "width='1in' height='50mm'")).size.x, 96);
}

TEST(Picture, MistakesNameTheFile) {
    const test::Folder folder;
    const auto message = [&](const std::string& path) {
        return error_of([&] { read_picture(path); });
    };
    EXPECT_EQ(message(folder.file("none.png")), folder.file("none.png") + ": no such file");
    EXPECT_NE(message(folder.file("none.svg")).find(folder.file("none.svg")), std::string::npos);

    write_png(folder.file("whole.png"), Image(64, 64, {"R", "G", "B"}));
    const std::string bytes = read_file(folder.file("whole.png"));
    const std::string cut = folder.write("cut.png", bytes.substr(0, bytes.size() / 2));
    testing::internal::CaptureStderr();
    EXPECT_EQ(message(cut).find(cut + ": is not a valid image"), 0U) << message(cut);
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "libpng prints nothing of its own";

    // A header of 200,000 x 200,000 pixels with a valid checksum.
    std::string huge = bytes;
    const unsigned char header[] = {'I', 'H', 'D', 'R', 0, 3, 13, 64, 0, 3, 13, 64, 8, 2, 0, 0, 0};
    std::uint32_t crc = 0xffffffffU;
    for (const unsigned char byte : header) {
        crc ^= byte;
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xedb88320U : 0U);
    }
    huge.replace(12, sizeof header, reinterpret_cast<const char*>(header), sizeof header);
    for (int i = 0; i < 4; ++i)
        huge[std::size_t(29 + i)] = static_cast<char>(~crc >> (24 - 8 * i));
    const std::string large = folder.write("huge.png", huge);
    EXPECT_EQ(message(large).find(large + ": is too large: 200000 x 200000"), 0U) << message(large);

    const std::string text = folder.write("text.png", "no picture at all");
    EXPECT_EQ(message(text), text + ": is not a PNG, JPEG, EXR or HDR image");
    const std::string outside =
        folder.write("outside.svg", svg("<image xlink:href='https://example.org/a.png'/>"));
    EXPECT_EQ(message(outside), outside +
                                    ": line 2: image: xlink:href: refers to "
                                    "\"https://example.org/a.png\", outside the file; embed it");
}

TEST(Drawing, ExternalReferencesAreRejected) {
    for (const char* body :
         {"<image href='a.png'/>", "<image href='file:///etc/passwd'/>",
          "<use xlink:href='other.svg#leaf'/>", "<rect fill='url(other.svg#g)'/>",
          "<rect style='fill: URL( \"http://x/#g\" )'/>",
          "<rect style='fill:u\\72l(http://x/#g)'/>",
          "<image href='data:image/svg+xml;base64,AAAA'/>", "<feImage href='//x/a.png'/>",
          "<rect mask='image-set(\"a.png\" 1x)'/>", "<style>rect { fill: url(a.svg#b) }</style>",
          "<style>@import 'a.css';</style>", "<style>/* x */ @font-face { src: url(#a) }</style>"})
        EXPECT_EQ(refusal(body).find("line 2: "), 0U) << body << "\n" << refusal(body);
    for (const char* body : {"<use href='#leaf'/>", "<rect fill='url(#g)'/>",
                             "<a href='https://example.org'><rect/></a>",
                             "<style>/* @import */ .a, rect { fill: url('#g') }</style>"})
        EXPECT_EQ(refusal(body), "no error") << body;
}

TEST(Drawing, ScriptsEntitiesAndDepthAreRefused) {
    EXPECT_NE(refusal("<script>alert(1)</script>").find("\"script\""), std::string::npos);
    EXPECT_NE(refusal("<svg:script/>").find("\"script\""), std::string::npos);
    EXPECT_NE(refusal("<foreignObject/>").find("foreignObject"), std::string::npos);
    EXPECT_NE(refusal("<rect onclick='x()'/>").find("onclick"), std::string::npos);
    EXPECT_NE(refusal("<a><set attributeName='xlink:href' to='javascript:x'/></a>")
                  .find("animates a reference"),
              std::string::npos);
    const std::string bomb =
        "<!DOCTYPE svg [<!ENTITY a 'aaaaaaaa'><!ENTITY b '&a;&a;&a;'>]>" + svg("&b;");
    EXPECT_NE(error_of([&] { read_drawing(bomb); }).find("declares entities"), std::string::npos);
    std::string deep;
    for (int i = 0; i < 100'000; ++i)
        deep += "<g>";
    EXPECT_NE(refusal(deep), "no error");
    for (int i = 0; i < 100'000; ++i)
        deep += "</g>";
    EXPECT_NE(refusal(deep).find("nested more than 200 deep"), std::string::npos);
    EXPECT_NE(refusal("", "").find("has no size"), std::string::npos);
    EXPECT_NE(refusal("", "width='0' height='1'").find("has no size"), std::string::npos);
    EXPECT_NE(error_of([] { read_drawing("<html/>"); }).find("expected svg"), std::string::npos);
    EXPECT_NE(error_of([] { read_drawing("<svg"); }).find("line 1"), std::string::npos);
    // Nested <use> elements that give 2^40 rectangles.
    std::string uses = "<defs><rect id='u0' width='1' height='1'/>";
    for (int i = 1; i <= 40; ++i)
        for (const std::string to = std::to_string(i - 1); const char* part : {"<g id='u", ""}) {
            if (*part != 0)
                uses += part + std::to_string(i) + "'>";
            uses += "<use xlink:href='#u" + to + "'/>" + (*part != 0 ? "" : "</g>");
        }
    const test::Folder folder;
    const std::string path =
        folder.write("uses.svg", svg(uses + "</defs><use xlink:href='#u40'/>"));
    EXPECT_EQ(error_of([&] { read_picture(path); }).find(path + ": line "), 0U);
    EXPECT_NE(error_of([&] { read_picture(path); }).find("elements are drawn, with clones"),
              std::string::npos);
}

// Two drawings with equal ids and classes in one document.
TEST(Drawing, EmbeddedDrawingsAreIndependent) {
    const auto one = [](const char* color) {
        return read_drawing(
                   svg("<style>.a { fill: url(#g) } rect#b, #c{stroke:none}</style>"
                       "<linearGradient id='g'><stop stop-color='" +
                       std::string(color) +
                       "'/></linearGradient><rect id='b' class='a' width='40' height='20'/>"))
            .markup;
    };
    const std::string red = embedded_drawing(one("red"), "r-", "r", {{0, 0}, {40, 20}});
    const std::string blue = embedded_drawing(one("blue"), "b-", "b", {{0, 20}, {40, 40}});
    EXPECT_NE(red.find("#r .a{ fill: url(#r-g) }#r rect#r-b,#r #r-c{stroke:none}"),
              std::string::npos)
        << red;
    const std::string both =
        svg("<g id='r'>" + red + "</g><g id='b'>" + blue + "</g>", "width='40' height='40'");
    const Image image = rasterised(both, {40, 40}, 40, 40);
    EXPECT_EQ(image.at(20, 10)[0], 1.0F);
    EXPECT_EQ(image.at(20, 10)[2], 0.0F);
    EXPECT_EQ(image.at(20, 30)[0], 0.0F);
    EXPECT_EQ(image.at(20, 30)[2], 1.0F);
}

std::string big_endian(std::uint32_t value, int count) {
    std::string out;
    for (int i = count - 1; i >= 0; --i)
        out += static_cast<char>(value >> (8 * i) & 255U);
    return out;
}

TEST(EmbeddedPicture, IsBoundedByItsHeader) {
    const auto problem = [](const std::string& bytes) {
        return error_of([&] { check_embedded_picture("data:image/png;base64," + base64(bytes)); });
    };
    const auto png = [](std::uint32_t width, std::uint32_t height) {
        return "\x89PNG\r\n\x1a\n" + big_endian(13, 4) + "IHDR" + big_endian(width, 4) +
               big_endian(height, 4);
    };
    const auto jpeg = [](std::uint32_t width, std::uint32_t height) {
        return "\xff\xd8\xff\xe0" + big_endian(4, 2) + "xx\xff\xc2" + big_endian(11, 2) + "\x08" +
               big_endian(height, 2) + big_endian(width, 2) + "rest";
    };
    EXPECT_EQ(problem(png(4000, 3000)), "no error");
    EXPECT_EQ(problem(jpeg(4000, 3000)), "no error");
    const std::string too_large =
        "holds a picture of 30000 x 30000 pixels; at most 33554432 are read";
    EXPECT_EQ(problem(png(30000, 30000)), too_large);
    EXPECT_EQ(problem(jpeg(30000, 30000)), too_large);
    for (const std::string& bytes :
         {std::string("GIF89a"), std::string("II*"), png(0, 10), png(10, 10).substr(0, 15),
          std::string("\xff\xd8\xff\xff\xff")})
        EXPECT_EQ(problem(bytes), "holds what is no PNG or JPEG picture");
    for (const char* uri : {"data:image/png,x", "data:image/png;base64,?", "data:image/png;base64"})
        EXPECT_EQ(error_of([&] { check_embedded_picture(uri); }),
                  "holds a picture that is not in base64");
}

TEST(ReadDrawing, ClonesOfClonesAreCounted) {
    std::string defs = "<rect id='a0' width='1' height='1'/>";
    for (int i = 1; i <= 11; ++i) {
        defs += "<g id='a" + std::to_string(i) + "'>";
        for (int k = 0; k < 10; ++k)
            defs += "<use href='#a" + std::to_string(i - 1) + "'/>";
        defs += "</g>";
    }
    const auto problem = [&](const std::string& last) {
        return error_of([&] {
            read_drawing("<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'><defs>" +
                         defs + "</defs><use href='#" + last + "'/></svg>");
        });
    };
    EXPECT_EQ(problem("a4"), "no error");
    EXPECT_EQ(problem("a11"), "line 1: more than 200000 elements are drawn, with clones");
}

} // namespace
} // namespace scree
