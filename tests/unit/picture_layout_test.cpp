// SPDX-License-Identifier: GPL-3.0-or-later
// Layouts of pictures as pixels and as SVG, which must look the same.
#include "core/base64.h"
#include "core/display_encoding.h"
#include "core/drawing.h"
#include "core/drawing_raster.h"
#include "core/random.h"
#include "formats/layout_picture.h"
#include "geometry/plane/ground_plane.h"
#include "geometry/plane/picture_shape.h"
#include "geometry/plane/region_tools.h"
#include "tests/support/pictures.h"

#include <gtest/gtest.h>

#include <regex>

namespace scree {
namespace {

using test::error_of;
using test::svg;

Color green(const Aggregate&, const Instance&) { return {0.1F, 0.6F, 0.2F}; }

std::shared_ptr<const Region> rectangle(double width, double depth) {
    const double x = width / 2, z = depth / 2;
    return std::make_shared<Region>(triangulate({{{-x, -z}, {x, -z}, {x, z}, {-x, z}}}));
}

// A half-transparent asymmetric arrow with a hole, which points to the far side.
std::string arrow() {
    return svg("<defs><linearGradient id='g' x2='0' y2='1'><stop stop-color='#e04010'/>"
               "<stop offset='1' stop-color='#2040c0'/></linearGradient></defs>"
               "<path fill='url(#g)' fill-rule='evenodd' d='M30 5L55 40H40V95H20V40H5Z"
               "M25 50H35V60H25Z'/><rect x='40' y='70' width='15' height='10' opacity='0.5'/>",
               "viewBox='0 0 60 100'");
}

Image arrow_pixels() { return rasterised(read_drawing(arrow()).markup, {60, 100}, 300, 500); }

/// A texture with arrows as pixels and as drawings, and rectangles, at random places.
Aggregate arrows(bool torus, const test::Folder& folder, std::uint64_t seed = 1) {
    Aggregate aggregate;
    aggregate.generator = "test";
    aggregate.domain = rectangle(0.4, 0.3);
    aggregate.texture = true;
    aggregate.torus = torus;
    write_png(folder.file("arrow.png"), display_image(arrow_pixels()));
    folder.write("arrow.svg", arrow());
    for (const char* name : {"arrow.png", "arrow.svg"}) {
        const PictureShape shape = picture_shape(read_picture(folder.file(name), 300), 0.08);
        aggregate.prototypes.push_back({name, shape.mesh, shape.region, {}, shape.picture});
    }
    aggregate.prototypes.push_back({"plain", {}, rectangle(0.05, 0.02), {}, nullptr});
    Random random(seed, Purpose::test, 0);
    for (std::uint32_t i = 0; i < 30; ++i) {
        const double angle = random.uniform(0, 2 * pi);
        const double scale = random.uniform(0.5, 1.2);
        const Vec2 x = rotate({scale, 0}, angle), z = rotate({0, scale}, angle);
        const Vec2 at(random.uniform(-0.2, 0.2), random.uniform(-0.15, 0.15));
        const auto f = [](double v) { return static_cast<float>(v); };
        aggregate.instances.push_back({i % 3,
                                       {f(x.x), 0, f(x.y), 0, 0, f(scale), 0, 0, f(z.x), 0, f(z.y),
                                        0, f(at.x), 0, f(at.y), 1},
                                       0,
                                       angle,
                                       scale});
    }
    return aggregate;
}

Image drawn(const Aggregate& aggregate, int size) {
    return layout_image({&aggregate, 1}, green, {.pixels = size});
}

/// The SVG output rasterised by librsvg.
Image svg_drawn(const Aggregate& aggregate, int width, int height) {
    const std::string markup = layout_svg({&aggregate, 1}, green);
    return rasterised(markup, drawing_size(markup), width, height);
}

struct Comparison {
    double mean = 0;
    double different = 0; // share of values that differ by more than a tenth
};

Comparison compare(const Image& a, const Image& b) {
    EXPECT_EQ(a.pixels.size(), b.pixels.size());
    Comparison out;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) {
        const double d = std::abs(double(a.pixels[i]) - double(b.pixels[i]));
        out.mean += d / double(a.pixels.size());
        out.different += d > 0.1 ? 1 / double(a.pixels.size()) : 0;
    }
    return out;
}

TEST(PictureLayout, SvgAndPixelsShowTheSame) {
    const test::Folder folder;
    for (const bool torus : {false, true}) {
        const Aggregate aggregate = arrows(torus, folder);
        const Image pixels = drawn(aggregate, 800);
        ASSERT_EQ(pixels.width, 800);
        ASSERT_EQ(pixels.height, 600);
        // librsvg blends edges in display encoding and filters embedded pixels more coarsely.
        const Comparison d = compare(pixels, svg_drawn(aggregate, 800, 600));
        EXPECT_LT(d.mean, 0.006) << torus;
        EXPECT_LT(d.different, 0.02) << torus;
        if (const char* keep = std::getenv("SCREE_KEEP"); keep != nullptr) {
            const std::string path = std::string(keep) + (torus ? "/torus" : "/plain");
            write_png(path + ".png", display_image(pixels));
            write_png(path + "_svg.png", display_image(svg_drawn(aggregate, 800, 600)));
            write_file(path + ".svg", layout_svg({&aggregate, 1}, green));
        }
    }
}

TEST(PictureLayout, EachPictureIsOneSymbol) {
    const test::Folder folder;
    const Aggregate aggregate = arrows(false, folder);
    const std::string text = layout_svg({&aggregate, 1}, green);
    const auto count = [&](const char* what) {
        const std::regex pattern(what);
        return std::distance(std::sregex_iterator(text.begin(), text.end(), pattern),
                             std::sregex_iterator());
    };
    EXPECT_EQ(count("<symbol "), 2);
    EXPECT_EQ(count("<image "), 1);
    EXPECT_EQ(count("<use xlink:href=\"#a0p[01]\" transform=\"[^\"]*\"/>"), 20);
    EXPECT_EQ(count("<use xlink:href=\"#a0p2\" transform=\"[^\"]*\" fill=\"#1a9933\"/>"), 10);
    EXPECT_EQ(count("id=\"a0p1-g\""), 1);
    EXPECT_EQ(count("class=\"(ground|domain)\""), 0);
    EXPECT_EQ(base64("Man"), "TWFu");
    EXPECT_EQ(base64("Ma"), "TWE=");
    EXPECT_EQ(base64("M"), "TQ==");
}

// Moving a layout by half a period moves its tile by half a period.
TEST(PictureLayout, ATorusIsOnePeriodWithoutASeam) {
    const test::Folder folder;
    Aggregate aggregate = arrows(true, folder);
    // Odd sizes, so that texels of the background's mip levels do not align with pixels.
    Picture waves{"waves",
                  test::picture_of(333, 211,
                                   [](double x, double y) {
                                       const auto v = static_cast<float>(
                                           0.5 + 0.4 * std::sin(2 * pi * (3 * x + y)));
                                       return std::array{v, 0.3F, 1 - v, 1.0F};
                                   }),
                  {},
                  {}};
    aggregate.background = std::make_shared<Picture>(waves);
    const Image tile = drawn(aggregate, 400);
    ASSERT_EQ(tile.height, 300);
    for (Instance& instance : aggregate.instances) {
        double& x = instance.world_from_object[3][0];
        double& z = instance.world_from_object[3][2];
        x += x < 0 ? 0.2 : -0.2;
        z += z < 0 ? 0.15 : -0.15;
    }
    Picture moved = waves;
    // The background moved by half a period, sampled again.
    moved.image = test::picture_of(333, 211, [](double x, double y) {
        const auto v = static_cast<float>(0.5 + 0.4 * std::sin(2 * pi * (3 * (x + 0.5) + y + 0.5)));
        return std::array{v, 0.3F, 1 - v, 1.0F};
    });
    aggregate.background = std::make_shared<Picture>(moved);
    const Image other = drawn(aggregate, 400);
    Image rolled = other;
    for (int y = 0; y < 300; ++y)
        for (int x = 0; x < 400; ++x)
            std::copy_n(other.at((x + 200) % 400, (y + 150) % 300), 4, rolled.at(x, y));
    const Comparison d = compare(tile, rolled);
    EXPECT_LT(d.mean, 1e-3);
    EXPECT_EQ(d.different, 0);
    for (std::size_t i = 3; i < tile.pixels.size(); i += 4)
        ASSERT_NEAR(tile.pixels[i], 1, 1e-5);
}

TEST(PictureLayout, ATextureIsTransparentBetweenElements) {
    const test::Folder folder;
    Aggregate aggregate = arrows(false, folder);
    aggregate.instances.resize(1);
    const Image image = drawn(aggregate, 200);
    EXPECT_EQ(image.width, 200);
    EXPECT_EQ(image.height, 150);
    double clear = 0;
    for (std::size_t i = 3; i < image.pixels.size(); i += 4)
        clear += image.pixels[i] == 0 ? 1 : 0;
    EXPECT_GT(clear, 0.9 * image.width * image.height);
    // A layout that is not a texture has paper.
    aggregate.texture = false;
    const Image paper = drawn(aggregate, 200);
    EXPECT_NEAR(paper.at(0, 0)[3], 1, 1e-6);
    EXPECT_NEAR(paper.at(0, 0)[0], 1, 1e-6);
}

TEST(PictureLayout, ATorusOfALayoutIsOnePeriodWithoutASeam) {
    const test::Folder folder;
    Aggregate aggregate = arrows(true, folder);
    aggregate.texture = false;
    const std::vector<Aggregate> one{aggregate};
    EXPECT_EQ(picture_box(one).size(), bounds(*aggregate.domain).size());
    Aggregate bare = aggregate;
    bare.instances.clear();
    for (const Image& image : {drawn(bare, 80), svg_drawn(bare, 80, 60)})
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x)
                for (std::size_t c = 0; c < 4; ++c) // ground everywhere: neither frame nor outline
                    ASSERT_NEAR(image.at(x, y)[c], image.at(40, 30)[c], 1e-5) << x << " " << y;
    // Half a period on, what was the seam is in the middle, and nothing else changes.
    Aggregate moved = aggregate;
    for (Instance& instance : moved.instances)
        instance.world_from_object[3][0] += instance.world_from_object[3][0] > 0 ? -0.2 : 0.2;
    const Image here = drawn(aggregate, 80), there = drawn(moved, 80);
    for (int y = 0; y < here.height; ++y)
        for (int x = 0; x < here.width; ++x)
            for (std::size_t c = 0; c < 4; ++c)
                ASSERT_NEAR(here.at(x, y)[c], there.at((x + 40) % 80, y)[c], 1e-4) << x << " " << y;
}

TEST(PictureLayout, BackgroundsFillTheDomain) {
    const test::Folder folder;
    Aggregate aggregate = arrows(false, folder);
    aggregate.instances.clear();
    aggregate.background = std::make_shared<Picture>(
        Picture{"quarters",
                test::picture_of(
                    2, 2,
                    [](double x, double y) {
                        return std::array{x < 0.5 ? 1.0F : 0.0F, y < 0.5 ? 1.0F : 0.0F, 0.5F, 1.0F};
                    }),
                {},
                {}});
    for (const Image& image : {drawn(aggregate, 80), svg_drawn(aggregate, 80, 60)}) {
        EXPECT_GT(image.at(1, 1)[0], 0.95F);
        EXPECT_GT(image.at(1, 1)[1], 0.95F);
        EXPECT_LT(image.at(78, 58)[0], 0.05F);
        EXPECT_LT(image.at(78, 58)[1], 0.05F);
        EXPECT_EQ(image.at(40, 0)[3], 1.0F);
    }
}

TEST(PictureShape, OutlineAndPictureCoincide) {
    const test::Folder folder;
    const std::string path = folder.write("arrow.svg", arrow());
    const PictureShape shape = picture_shape(read_picture(path, 400), 0.09);
    const Box2 box = bounds(*shape.region);
    EXPECT_NEAR(box.size().y, 0.09, 1e-12);
    EXPECT_NEAR(box.center().length(), 0, 1e-12);
    EXPECT_NEAR(shape.picture->box.size().y, 0.1, 5e-4); // the picture is 100 high, the arrow 90
    EXPECT_NEAR(area(*shape.region), 1e-6 * (0.5 * 50 * 35 + 20 * 55 - 100 + 150), 2e-5);
    // The UVs of every vertex give its position in the picture.
    for (std::size_t i = 0; i < shape.mesh->positions.size(); ++i) {
        const Vec2 uv(shape.mesh->uvs[i]);
        const Box2& whole = shape.picture->box;
        EXPECT_NEAR(whole.min.x + uv.x * whole.size().x, double(shape.mesh->positions[i].x), 1e-7);
        EXPECT_NEAR(whole.max.y - uv.y * whole.size().y, double(shape.mesh->positions[i].z), 1e-7);
    }
    // The outline of an opaque picture is its rectangle.
    write_png(folder.file("photo.png"), Image(60, 40, {"R", "G", "B"}));
    const PictureShape photo = picture_shape(read_picture(folder.file("photo.png")), 0.3);
    EXPECT_NEAR(area(*photo.region), 0.3 * 0.2, 0.001);
    EXPECT_NEAR(photo.picture->box.size().x, 0.3, 0.003); // a pixel is 5 mm
}

TEST(PictureShape, MistakesAreLocated) {
    const test::Folder folder;
    Params component("generator.elements.components[1]", {"scene.lua", 4});
    component.set("picture", folder.file("none.png"), {"scene.lua", 5});
    component.set("resolution", std::int64_t{64});
    EXPECT_EQ(error_of([&] {
                  picture_shape(component);
              }).find("scene.lua:4: generator.elements.components[1].size: is missing"),
              0U)
        << error_of([&] { picture_shape(component); });
    component.set("size", 0.1);
    EXPECT_EQ(error_of([&] { picture_shape(component); })
                  .find("scene.lua:5: generator.elements.components[1].picture: " +
                        folder.file("none.png")),
              0U);
    component.set("picture", folder.write("empty.svg", svg("")), {"scene.lua", 5});
    EXPECT_NE(error_of([&] { picture_shape(component); }).find("nothing of the picture is opaque"),
              std::string::npos);
}

} // namespace
} // namespace scree
