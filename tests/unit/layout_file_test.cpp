// SPDX-License-Identifier: GPL-3.0-or-later
// Layouts written as JSON, SVG and pictures, and read back.
#include "core/canvas.h"
#include "core/display_encoding.h"
#include "core/error.h"
#include "formats/layout_picture.h"
#include "formats/read_bake_json.h"
#include "formats/write_bake_json.h"
#include "geometry/plane/ground_plane.h"

#include <gtest/gtest.h>

#include <map>
#include <regex>

namespace scree {
namespace {

// Two instances of a square with a square hole: one in the middle of a rectangle, one rotated,
// scaled and across its border.
Aggregate two_frames(bool torus) {
    Aggregate aggregate;
    aggregate.generator = "layout";
    aggregate.seed = 7;
    aggregate.torus = torus;
    aggregate.domain = std::make_shared<Region>(Region{{{{0, 0}, {2, 0}, {2, 1}, {0, 1}}}, {}, {}});
    Prototype frame;
    frame.name = "frame <\"&\">";
    frame.region =
        std::make_shared<Region>(Region{{{{-0.2, -0.2}, {0.2, -0.2}, {0.2, 0.2}, {-0.2, 0.2}},
                                         {{-0.1, -0.1}, {-0.1, 0.1}, {0.1, 0.1}, {0.1, -0.1}}},
                                        {},
                                        {}});
    aggregate.prototypes.push_back(frame);
    for (const Vec2& at : {Vec2(0.5, 0.5), Vec2(2, 0.5)}) {
        Instance instance;
        instance.scale = aggregate.instances.empty() ? 1 : 1.25;
        instance.angle = aggregate.instances.empty() ? 0 : radians(30);
        const Vec2 x = rotate({instance.scale, 0}, instance.angle);
        const Vec2 z = rotate({0, instance.scale}, instance.angle);
        instance.world_from_object =
            WideMatrix(x.x, 0, x.y, 0, 0, instance.scale, 0, 0, z.x, 0, z.y, 0, at.x, 0, at.y, 1);
        aggregate.instances.push_back(instance);
    }
    return aggregate;
}

Color dark(const Aggregate&, const Instance&) { return {0, 0, 0}; }

std::vector<Aggregate> read(const std::string& text) { return read_bake_json(text, "a.json"); }

std::string message(const std::string& text) {
    try {
        read(text);
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

// A strand of two points and one of three, twice as large as its prototype.
Aggregate two_strands(CurveKind kind) {
    auto strands = std::make_shared<Strands>();
    strands->offsets = {0, 4, 9};
    strands->kind = kind;
    for (int i = 0; i < 9; ++i) {
        strands->points.emplace_back(0.1F * static_cast<float>(i), 0.3F, -1.7F);
        strands->radii.push_back(0.001F * static_cast<float>(1 + i));
    }
    Aggregate aggregate;
    aggregate.generator = "fibres";
    aggregate.prototypes.push_back({.name = "hair", .shape = strands});
    Instance& instance = aggregate.instances.emplace_back();
    instance.world_from_object.setScale(2.0);
    return aggregate;
}

TEST(BakeJson, HoldsStrandsInPlaceOfInstances) {
    const Aggregate written = two_strands(CurveKind::linear);
    const std::string text = bake_json({&written, 1}, {"s.lua", 7});
    EXPECT_NE(text.find("\"strands\": 2,"), std::string::npos) << text;
    EXPECT_EQ(text.find("triangles"), std::string::npos);
    EXPECT_EQ(text.find("instances"), std::string::npos);
    EXPECT_NE(text.find("-3.4\n"), std::string::npos) << "as short as a float can be";
}

TEST(ReadBakeJson, GivesBackStrands) {
    for (const CurveKind kind : {CurveKind::linear, CurveKind::bspline}) {
        const Aggregate written = two_strands(kind);
        const std::vector<Aggregate> all = read(bake_json({&written, 1}, {"s.lua", 7}));
        ASSERT_EQ(all.size(), 1U);
        const Strands& before = *written.prototypes[0].strands();
        const Strands& after = *all[0].prototypes[0].strands();
        EXPECT_EQ(after.name, "hair");
        EXPECT_EQ(after.kind, kind);
        EXPECT_EQ(after.offsets, before.offsets);
        for (std::size_t i = 0; i < before.points.size(); ++i) {
            EXPECT_EQ(after.points[i], before.points[i] * 2.0F);
            EXPECT_EQ(after.radii[i], before.radii[i] * 2.0F);
        }
        ASSERT_EQ(all[0].instances.size(), 1U);
        EXPECT_EQ(all[0].instances[0].world_from_object, WideMatrix());
    }
}

TEST(ReadBakeJson, ErrorsInStrands) {
    const std::string head = "{\"aggregates\": [{\"generator\": \"fibres\", \"prototypes\": "
                             "[{\"name\": \"hair\", \"curve\": \"bspline\"}], \"strands\": [";
    const std::string points = "\"points\": [[0,0,0],[1,0,0],[2,0,0],[3,0,0]]";
    const std::string at = "a.json: aggregates[0].strands[0]";
    EXPECT_EQ(message(head + "{" + points + ", \"radius\": [1,1,1,1]}]}]}"), "no error");
    EXPECT_EQ(message(head + "{" + points + ", \"radius\": [1,1,1]}]}]}"),
              at + ".radius: expected one number for each point, got array of 3");
    EXPECT_EQ(message(head + "{" + points + ", \"radius\": [1,1,-1,1]}]}]}"),
              at + ".radius[2]: expected a number that is not below 0, got -1");
    EXPECT_EQ(message(head + "{\"points\": [[0,0,0],[1,0,0]], \"radius\": [1,1]}]}]}"),
              at + ".points: expected a list of at least 4 points, got array of 2");
    EXPECT_EQ(message(head + "{\"prototype\": 1, " + points + ", \"radius\": [1,1,1,1]}]}]}"),
              at + ".prototype: expected the index of a prototype, got 1");
}

TEST(ReadBakeJson, GivesBackWhatWasWritten) {
    for (const bool torus : {false, true}) {
        const Aggregate written = two_frames(torus);
        const std::string text = bake_json(std::span(&written, 1), {"s.lua", 7});
        EXPECT_TRUE(is_bake_json(text));
        const std::vector<Aggregate> all = read(text);
        ASSERT_EQ(all.size(), 1U);
        EXPECT_EQ(all[0].torus, torus);
        EXPECT_EQ(all[0].seed, 7U);
        EXPECT_EQ(all[0].domain->rings, written.domain->rings);
        EXPECT_EQ(all[0].prototypes[0].name, written.prototypes[0].name);
        EXPECT_EQ(all[0].prototypes[0].region->rings, written.prototypes[0].region->rings);
        ASSERT_EQ(all[0].instances.size(), 2U);
        EXPECT_EQ(all[0].instances[1].world_from_object, written.instances[1].world_from_object);
        EXPECT_NEAR(all[0].instances[1].angle, radians(30), 1e-12);
    }
    EXPECT_FALSE(is_bake_json("{\"kind\": \"scene\"}"));
}

TEST(ReadBakeJson, ErrorsNameFileAndKey) {
    const Aggregate good = two_frames(true);
    const std::string text = bake_json(std::span(&good, 1), {"s.lua", 7});
    const auto changed = [&](const char* pattern, const char* by) {
        const std::string out = std::regex_replace(text, std::regex(pattern), by,
                                                   std::regex_constants::format_first_only);
        EXPECT_NE(out, text) << pattern;
        return message(out);
    };
    EXPECT_EQ(message("{\n\"aggregates\": [,]"), "a.json:2: is not JSON");
    EXPECT_EQ(message("{}"), "a.json: aggregates: is missing");
    EXPECT_EQ(message("[]"), "a.json: expected an object, got array of 0");
    EXPECT_EQ(message("{\"aggregates\": 3}"), "a.json: aggregates: expected a list, got 3");
    EXPECT_EQ(changed("\"prototype\": 0", "\"prototype\": 1"),
              "a.json: aggregates[0].instances[0].prototype: expected the index of one of 1 "
              "prototypes, got 1");
    EXPECT_EQ(changed("\"matrix\": \\[[^,]*,", "\"matrix\": ["),
              "a.json: aggregates[0].instances[0].matrix: expected 12 numbers, got array of 11");
    EXPECT_EQ(changed("\"scale\": 1.0", "\"scale\": \"big\""),
              "a.json: aggregates[0].instances[0].scale: expected a number, got \"big\"");
    EXPECT_EQ(changed("\"torus\": true", "\"torus\": 1"),
              "a.json: aggregates[0].domain.torus: expected true or false, got 1");
    EXPECT_EQ(changed("\"scale\": 1.0", "\"scale\": 1e30"),
              "a.json: aggregates[0].instances[0].scale: expected a number between -1e9 and 1e9, "
              "got 1e+30");
    EXPECT_EQ(changed("\"rings\"", "\"ring\""), "a.json: aggregates[0].domain.rings: is missing");
    EXPECT_EQ(message(R"({"aggregates": [{"generator": "g", "domain": {"rings":
                          [[[0, 0], [0, 1], [1, 0]]]}}]})"),
              "a.json: aggregates[0].domain.rings: has no area; outer rings turn "
              "counter-clockwise, holes clockwise");
    EXPECT_EQ(message(R"({"aggregates": [{"generator": "g", "domain": {"torus": true, "rings":
                          [[[0, 0], [1, 0], [0, 1]]]}}]})"),
              "a.json: aggregates[0].domain.torus: a torus needs a rectangle along the axes for "
              "its domain");
}

// The area of the drawn paths [mm^2], with the transforms applied as by a viewer.
double drawn_area(const std::string& svg, int* uses) {
    std::map<std::string, double> areas;
    static const std::regex path(R"re(<path id="(a\d+p\d+)"[^>]* d="([^"]*)")re");
    for (std::sregex_iterator it(svg.begin(), svg.end(), path), end; it != end; ++it) {
        std::string data = (*it)[2];
        double area = 0;
        for (std::size_t from = 0, to; (to = data.find('Z', from)) != std::string::npos;
             from = to + 1) {
            Ring ring;
            double x = 0, y = 0;
            int length = 0;
            const char* at = data.c_str() + from + 1; // after M
            while (std::sscanf(at, " %lf,%lf%n", &x, &y, &length) == 2) {
                ring.emplace_back(x, y);
                at += length;
            }
            area += signed_area(ring);
        }
        areas[(*it)[1]] = area;
    }
    double sum = 0;
    static const std::regex use(R"re(<use xlink:href="#([^"]*)" transform="matrix\(([^)]*)\)")re");
    *uses = 0;
    for (std::sregex_iterator it(svg.begin(), svg.end(), use), end; it != end; ++it, ++*uses) {
        double a = 0, b = 0, c = 0, d = 0;
        EXPECT_EQ(std::sscanf((*it)[2].str().c_str(), "%lf %lf %lf %lf", &a, &b, &c, &d), 4);
        sum += areas.at((*it)[1]) * (a * d - b * c);
    }
    return sum;
}

TEST(LayoutSvg, DrawsEveryRegionWithItsArea) {
    const Aggregate aggregate = two_frames(false);
    const std::string svg = layout_svg(std::span(&aggregate, 1), dark);
    double expected = 0;
    for (const Instance& instance : aggregate.instances)
        expected +=
            1e6 * area(ground_region(*aggregate.prototypes[0].region, instance.world_from_object));
    int uses = 0;
    EXPECT_NEAR(drawn_area(svg, &uses), expected, 1e-3);
    EXPECT_NEAR(expected, 1e6 * 0.12 * (1 + 1.25 * 1.25), 1);
    EXPECT_EQ(uses, 2);
    // Names are escaped; sizes are millimetres.
    EXPECT_NE(svg.find("<title>frame &#60;&#34;&#38;&#34;&#62;</title>"), std::string::npos);
    EXPECT_TRUE(std::regex_search(svg, std::regex("width=\"[0-9.]+mm\"")));
}

TEST(LayoutSvg, ATorusShowsThePeriodicCopies) {
    const Aggregate aggregate = two_frames(true);
    int uses = 0;
    drawn_area(layout_svg(std::span(&aggregate, 1), dark), &uses);
    EXPECT_EQ(uses, 3); // the second one appears on the left too
}

// The share of dark pixels is the covered share of the domain.
TEST(LayoutImage, CoversTheAreaOfTheRegions) {
    for (const bool torus : {false, true}) {
        const Aggregate aggregate = two_frames(torus);
        const Image image =
            display_image(layout_image(std::span(&aggregate, 1), dark, {.pixels = 3000}));
        EXPECT_EQ(image.width, 3000);
        double ink = 0;
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x)
                ink += *image.at(x, y) < 0.19 ? 1 : 0;
        const double scale = 3000 / picture_box(std::span(&aggregate, 1)).size().x;
        const double expected = 0.12 * (1 + 1.25 * 1.25) * scale * scale;
        EXPECT_NEAR(ink, expected, 0.015 * expected) << torus;
    }
}

TEST(LayoutImage, MarginsAreHiddenWhenAsked) {
    Aggregate aggregate = two_frames(false);
    aggregate.prototypes[0].outline = std::make_shared<Region>(
        Region{{{{-0.1, -0.1}, {0.1, -0.1}, {0.1, 0.1}, {-0.1, 0.1}}}, {}, {}});
    const std::span<const Aggregate> all(&aggregate, 1);
    const LayoutLook hidden{.pixels = 400, .margins = false};
    EXPECT_NE(layout_svg(all, dark).find("class=\"margins\""), std::string::npos);
    EXPECT_EQ(layout_svg(all, dark, hidden).find("margin"), std::string::npos);
    const Image with = layout_image(all, dark, {.pixels = 400});
    EXPECT_NE(layout_image(all, dark, hidden).pixels, with.pixels);
}

TEST(LayoutImage, NothingToSeeIsAnError) {
    const Aggregate nothing;
    EXPECT_THROW(layout_svg(std::span(&nothing, 1), dark), Error);
}

} // namespace
} // namespace scree
