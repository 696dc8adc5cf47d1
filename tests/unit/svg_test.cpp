// SPDX-License-Identifier: GPL-3.0-or-later
// SVG outlines against known areas and against the fill rules evaluated point by point.
#include "core/error.h"
#include "core/file.h"
#include "core/random.h"
#include "geometry/plane/svg/svg_document.h"
#include "geometry/plane/svg/svg_text.h"
#include "shapes/table.h"
#include "tests/support/errors.h"
#include "tests/support/folder.h"
#include "tests/support/plugin_params.h"
#include "tests/support/svg.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fmt/format.h>

namespace scree {
namespace {

std::vector<Ring> flat(const BezierPath& path, double tolerance = 1e-5) {
    std::size_t points = 0;
    return path.flatten(tolerance, points, 1'000'000);
}

double path_area(std::string_view data) {
    double sum = 0;
    for (const Ring& ring : flat(parse_path_data(data)))
        sum += signed_area(ring);
    return sum;
}

std::string svg(const std::string& body, const std::string& attributes = "") {
    return tests::svg(body, attributes);
}

Region drawn(const std::string& body, const std::string& attributes = "",
             const std::string& element = "") {
    return tests::svg_region(tests::svg(body, attributes), element);
}

int winding_number(const std::vector<Ring>& rings, const Vec2& p) {
    int number = 0;
    for (const Ring& ring : rings)
        for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
            const Vec2 a = ring[j] - p, b = ring[i] - p;
            if ((a.y > 0) == (b.y > 0))
                continue;
            if ((cross(a, b) > 0) == (b.y > a.y))
                number += b.y > a.y ? 1 : -1;
        }
    return number;
}

TEST(SvgPath, AllCommandsAbsoluteAndRelative) {
    // Each draws the unit square with different commands.
    for (const char* data :
         {"M0 0 L1 0 L1 1 L0 1 Z", "m0,0 1,0 0,1 -1,0z", "M0 0H1V1H0Z", "m0 0h1v1h-1z",
          "M0 0C0 0 1 0 1 0C1 0 1 1 1 1L0 1", "m0 0c0 0 1 0 1 0s0 1 0 1l-1 0z",
          "M0 0Q.5 0 1 0T1 0V1H0", "M0,0L1,0 1,1 0,1", "M 0 0 L 1 0 L 1 1 L 0 1 L 0 0 z",
          "M0-0L1 0 1 1e0 0 10e-1"})
        EXPECT_NEAR(path_area(data), 1, 1e-9) << data;
}

TEST(SvgPath, CurvesEncloseTheirAreas) {
    // Below a parabola through (0, 0) and (2, 0) with its control point at (1, 2): 2/3 of 2 * 1.
    EXPECT_NEAR(path_area("M0 0Q1 2 2 0Z"), -4.0 / 3, 1e-4);
    EXPECT_NEAR(path_area("m0 0q1 2 2 0z"), -4.0 / 3, 1e-4);
    // A reflected control point continues the wave: both halves cancel.
    EXPECT_NEAR(path_area("M0 0Q1 2 2 0T4 0Z"), 0, 1e-4);
    EXPECT_NEAR(path_area("M0 0q1 2 2 0t2 0Z"), 0, 1e-4);
    // The area below a cubic (0, 0), (0, h), (w, h), (w, 0) is 0.6 w h.
    EXPECT_NEAR(path_area("M0 0C0 2 3 2 3 0Z"), -3.6, 1e-4);
    EXPECT_NEAR(path_area("M0 0C0 2 3 2 3 0S6 -2 6 0Z"), 0, 1e-4);
}

TEST(SvgPath, ArcsLieOnTheirEllipse) {
    EXPECT_NEAR(path_area("M1 0A1 1 0 0 1 -1 0A1 1 0 0 1 1 0Z"), pi, 1e-4);
    EXPECT_NEAR(path_area("M2 0a2 1 0 1 1 -4 0a2 1 0 1 1 4 0z"), 2 * pi, 1e-3);
    EXPECT_NEAR(path_area("M1 0A1 1 0 0 0 -1 0A1 1 0 0 0 1 0Z"), -pi, 1e-4);
    // A quarter of a disk minus its triangle.
    EXPECT_NEAR(path_area("M1 0A1 1 0 0 1 0 1Z"), pi / 4 - 0.5, 1e-4);
    EXPECT_NEAR(path_area("M1 0A1 1 0 1 0 0 1Z"), -(3 * pi / 4 + 0.5), 1e-4);
    EXPECT_NEAR(path_area("M1 0a1 1 0 01-1 1Z"), pi / 4 - 0.5, 1e-4); // flags without spaces
    // Radii that are too small are scaled up to a half circle; a radius of 0 gives a line.
    EXPECT_NEAR(path_area("M0 0A.1 .1 0 0 1 2 0Z"), pi / 2, 1e-4);
    EXPECT_NEAR(path_area("M0 0A0 1 0 0 1 2 0L2 1Z"), 1, 1e-9);
    // Points of rotated ellipses satisfy |M^-1 (p - centre)| = 1.
    for (std::uint64_t i = 0; i < 200; ++i) {
        Random random(1, Purpose::test, i);
        const Vec2 radii(random.uniform(0.2, 3), random.uniform(0.2, 3));
        const double turn = random.uniform(-180, 180);
        const double first = random.uniform(0, 2 * pi);
        const double sweep = random.uniform(0.1, 6.1) * (random.below(2) == 0 ? 1 : -1);
        const Vec2 centre(random.uniform(-5, 5), random.uniform(-5, 5));
        const auto at = [&](double angle) {
            return centre + rotate(Vec2(radii.x * std::cos(angle), radii.y * std::sin(angle)),
                                   radians(turn));
        };
        const Vec2 from = at(first), to = at(first + sweep);
        const std::string data =
            fmt::format("M{} {}A{} {} {} {} {} {} {}", from.x, from.y, radii.x, radii.y, turn,
                        std::abs(sweep) > pi ? 1 : 0, sweep > 0 ? 1 : 0, to.x, to.y);
        const std::vector<Ring> rings = flat(parse_path_data(data), 1e-4);
        ASSERT_EQ(rings.size(), 1U);
        double turned = 0;
        Vec2 before = Vec2(std::cos(first), std::sin(first));
        for (const Vec2& p : rings[0]) {
            const Vec2 circle = rotate(p - centre, -radians(turn)) / radii;
            EXPECT_NEAR(circle.length(), 1, 1e-5) << data;
            turned += std::atan2(cross(before, circle), before.dot(circle));
            before = circle;
        }
        EXPECT_NEAR(turned, sweep, 1e-4) << data;
    }
}

TEST(SvgPath, MistakesAreNamed) {
    const auto message = [](std::string_view data) {
        return tests::error_of([&] { parse_path_data(data); });
    };
    EXPECT_EQ(message(""), "the path is empty");
    EXPECT_EQ(message("L1 1"),
              "expected the command M, with which a path begins at letter 1, found \"L1 1\"");
    EXPECT_EQ(message("M1"), "expected a number at the end");
    EXPECT_EQ(message("M1 1 L"), "expected a number at the end");
    EXPECT_EQ(message("M1 1 X2 2"), "expected a command at letter 6, found \"X2 2\"");
    EXPECT_EQ(message("M nan 0"), "expected a number at letter 3, found \"nan 0\"");
    EXPECT_EQ(message("M inf 0"), "expected a number at letter 3, found \"inf 0\"");
    EXPECT_EQ(message("M1e400 0"), "1e400 at letter 2 is too large: numbers go to 1e+09");
    EXPECT_EQ(message("M2e9 0"), "2e9 at letter 2 is too large: numbers go to 1e+09");
    EXPECT_EQ(message("M0 0A1 1 0 2 0 1 1"),
              "expected the flag 0 or 1 at letter 12, found \"2 0 1 1\"");
    EXPECT_EQ(message("M0 0L1,,1"), "expected a number at letter 8, found \",1\"");
    EXPECT_EQ(message("M0 0L1 1,Z"), "expected a number at letter 10, found \"Z\"");
    EXPECT_EQ(path_area("M0 0L1e-400 0"), 0);
}

TEST(SvgText, Transforms) {
    const auto image = [](std::string_view text, const Vec2& p) {
        return p * parse_transform(text);
    };
    const auto expect = [&](std::string_view text, const Vec2& want) {
        const Vec2 got = image(text, {1, 2});
        EXPECT_NEAR(got.x, want.x, 1e-12) << text;
        EXPECT_NEAR(got.y, want.y, 1e-12) << text;
    };
    expect("", {1, 2});
    expect("translate(10)", {11, 2});
    expect("translate(10, 20)", {11, 22});
    expect("scale(2)", {2, 4});
    expect("scale(2 -1)", {2, -2});
    expect("rotate(90)", {-2, 1});
    expect("rotate(90, 1, 0)", {-1, 0});
    expect("skewX(45)", {3, 2});
    expect("skewY(45)", {1, 3});
    expect("matrix(1 2 3 4 5 6)", {1 + 6 + 5, 2 + 8 + 6});
    expect("translate(10,20) scale(2)", {12, 24}); // the first one is outermost
    expect("scale(2),translate(10,20)", {22, 44});
    EXPECT_THROW(parse_transform("scale()"), Error);
    EXPECT_THROW(parse_transform("rotate(1 2)"), Error);
    EXPECT_THROW(parse_transform("turn(3)"), Error);
    EXPECT_THROW(parse_transform("scale(1"), Error);
    EXPECT_THROW(parse_transform("scale 1"), Error);
}

TEST(SvgText, Lengths) {
    EXPECT_DOUBLE_EQ(parse_length("3"), 3);
    EXPECT_DOUBLE_EQ(parse_length(" 3px "), 3);
    EXPECT_DOUBLE_EQ(parse_length("1in"), 96);
    EXPECT_DOUBLE_EQ(parse_length("25.4mm"), 96);
    EXPECT_DOUBLE_EQ(parse_length("72pt"), 96);
    EXPECT_DOUBLE_EQ(parse_length("5%", {.whole = 40}), 2);
    EXPECT_DOUBLE_EQ(parse_length("1.5em", {.font = 20}), 30);
    EXPECT_DOUBLE_EQ(parse_length("2EX", {.font = 20}), 20);
    for (const char* text : {"", "5%", "3em", "mm", "1 2"})
        EXPECT_THROW(parse_length(text), Error) << text;
}

TEST(SvgDocument, BasicShapes) {
    EXPECT_NEAR(area(drawn("<rect x='1' y='2' width='3' height='4'/>")), 12, 1e-6);
    EXPECT_NEAR(area(drawn("<circle cx='5' cy='5' r='2'/>")), 4 * pi, 1e-3);
    EXPECT_NEAR(area(drawn("<ellipse cx='5' rx='2' ry='3'/>")), 6 * pi, 1e-3);
    EXPECT_NEAR(area(drawn("<polygon points='0,0 4,0 4,3'/>")), 6, 1e-6);
    EXPECT_NEAR(area(drawn("<polyline points='0 0 4 0 4 3'/>")), 6, 1e-6);
    // Rounded corners remove (4 - pi) r^2. One radius stands for both and is at most half a side.
    const double lost = 4 - pi;
    EXPECT_NEAR(area(drawn("<rect width='6' height='5' rx='2'/>")), 30 - lost * 4, 1e-3);
    EXPECT_NEAR(area(drawn("<rect width='6' height='5' rx='2' ry='1'/>")), 30 - lost * 2, 1e-3);
    EXPECT_NEAR(area(drawn("<rect width='4' height='4' rx='9'/>")), 4 * pi, 1e-3);
}

TEST(SvgDocument, TransformsOfGroupsAndViewBoxes) {
    const auto box = [](const Region& region) { return bounds(region); };
    const Box2 moved =
        box(drawn("<g transform='translate(10 0)'><g transform='scale(2)'>"
                  "<rect width='1' height='3' transform='translate(1 1)'/></g></g>"));
    EXPECT_NEAR((moved.min - Vec2(12, 2)).length() + (moved.max - Vec2(14, 8)).length(), 0, 1e-6);
    const std::string unit = "<rect width='10' height='10'/>";
    // A viewBox of 10 x 10 in 40 x 20: scaled by 2 and centred; stretched; filling all.
    const auto fitted = [&](const std::string& aspect) {
        return box(drawn(unit, "width='40' height='20' viewBox='0 0 10 10' " + aspect));
    };
    EXPECT_NEAR((fitted("").min - Vec2(10, 0)).length(), 0, 1e-6);
    EXPECT_NEAR((fitted("").max - Vec2(30, 20)).length(), 0, 1e-6);
    EXPECT_NEAR((fitted("preserveAspectRatio='none'").max - Vec2(40, 20)).length(), 0, 1e-6);
    EXPECT_NEAR((fitted("preserveAspectRatio='xMinYMid meet'").min).length(), 0, 1e-6);
    EXPECT_NEAR((fitted("preserveAspectRatio='xMaxYMax slice'").min - Vec2(0, -20)).length(), 0,
                1e-6);
    const Box2 nested = box(drawn("<svg x='5' y='6' width='20' height='20' viewBox='10 10 10 10'>"
                                  "<rect x='10' y='10' width='5' height='10'/></svg>",
                                  "width='100mm' viewBox='0 0 100 50'"));
    const double mm = 96 / 25.4;
    EXPECT_NEAR((nested.min - Vec2(5, 6) * mm).length(), 0, 1e-5);
    EXPECT_NEAR((nested.max - Vec2(15, 26) * mm).length(), 0, 1e-5);
}

TEST(SvgDocument, WhatIsNotFilledIsLeftOut) {
    const std::string two = "<rect width='1' height='1'/>";
    EXPECT_NEAR(area(drawn(two + "<rect x='5' width='1' height='1' fill='none'/>")), 1, 1e-6);
    EXPECT_NEAR(area(drawn(two + "<g style='fill : none'><circle r='9'/></g>")), 1, 1e-6);
    EXPECT_NEAR(area(drawn(two + "<g display='none'><circle r='9'/></g>")), 1, 1e-6);
    EXPECT_NEAR(area(drawn(two + "<g visibility='hidden'><circle r='9'/></g>")), 1, 1e-6);
    EXPECT_NEAR(area(drawn(two + "<defs><circle r='9'/></defs><title>x</title>")), 1, 1e-6);
    EXPECT_NEAR(area(drawn(two + "<sodipodi:namedview/><metadata><q/></metadata>")), 1, 1e-6);
    EXPECT_NEAR(area(drawn("<svg:rect width='2' height='1'/>")), 2, 1e-6);
}

TEST(SvgDocument, OneElementById) {
    const std::string body = "<g id='a' transform='scale(2)'><rect id='b' width='1' height='1'/>"
                             "<rect id='c' x='5' width='1' height='2'/></g>"
                             "<defs><circle id='d' r='1'/></defs>";
    EXPECT_NEAR(area(drawn(body, "", "b")), 4, 1e-6);
    EXPECT_NEAR(area(drawn(body, "", "a")), 12, 1e-6);
    EXPECT_NEAR(area(drawn(body, "", "d")), pi, 1e-3);
    EXPECT_NE(tests::error_of([&] { drawn(body, "", "e"); }).find("no element has the id"),
              std::string::npos);
}

TEST(SvgFill, RulesDifferWhereAnOutlineCrossesItself) {
    // A pentagram, whose middle has the winding number 2.
    std::string points;
    for (int i = 0; i < 5; ++i)
        points += fmt::format("{},{} ", std::sin(4 * pi * i / 5), -std::cos(4 * pi * i / 5));
    const std::string star = "<polygon points='" + points + "' ";
    const double whole = area(drawn(star + "/>"));
    const double pierced = area(drawn(star + "fill-rule='evenodd'/>"));
    // The inner pentagon has the radius 1 / phi^2.
    const double inner = std::pow(2 / (1 + std::sqrt(5.0)), 2);
    const double pentagon = 2.5 * std::sin(2 * pi / 5) * inner * inner;
    EXPECT_NEAR(whole - pierced, pentagon, 1e-4);
    // A ring of opposite orientation is a hole by both rules, one of the same orientation only by
    // evenodd.
    const std::string outer = "M0 0H4V4H0Z";
    EXPECT_NEAR(area(drawn("<path d='" + outer + "M1 1V3H3V1Z'/>")), 12, 1e-6);
    EXPECT_NEAR(area(drawn("<path d='" + outer + "M1 1H3V3H1Z'/>")), 16, 1e-6);
    EXPECT_NEAR(area(drawn("<path fill-rule='evenodd' d='" + outer + "M1 1H3V3H1Z'/>")), 12, 1e-6);
    // The result is the union of all shapes, each filled by its own rule.
    EXPECT_NEAR(area(drawn("<path d='" + outer + "'/><rect x='2' y='2' width='4' height='4'/>")),
                28, 1e-6);
}

TEST(SvgFill, TouchingPartsAreSeparated) {
    // Two squares that touch at a corner, a figure of eight, a hole that touches its outline, and a
    // square with four holes that meet in the middle.
    for (const auto& [data, want] : std::vector<std::pair<std::string, double>>{
             {"M0 0H1V1H0ZM1 1H2V2H1Z", 2},
             {"M0 0L2 2V0L0 2Z", 2},
             {"M0 0H4V4H0ZM0 2L2 1V3Z", 16 - 2},
             {"M0 0H4V4H0ZM2 2H1V1H2ZM2 2V1H3V2ZM2 2H3V3H2ZM2 2V3H1V2Z", 16 - 4}}) {
        const Region region = drawn("<path fill-rule='evenodd' d='" + data + "'/>");
        EXPECT_NEAR(area(region), want, 1e-6) << data;
        EXPECT_NO_THROW(triangulate(region.rings)) << data; // it rejects touching rings
    }
}

// For random self-intersecting polygons the region contains exactly the points that the rule fills.
TEST(SvgFill, AgreesWithTheRulesPointByPoint) {
    for (std::uint64_t i = 0; i < 60; ++i) {
        Random random(7, Purpose::test, i);
        // Every other polygon is on a coarse grid, so that points and edges coincide.
        const bool coarse = i % 2 == 1;
        std::vector<FilledRings> shapes(1 + random.below(3));
        for (FilledRings& shape : shapes) {
            shape.rule = random.below(2) == 0 ? FillRule::nonzero : FillRule::evenodd;
            shape.rings.resize(1 + random.below(3));
            for (Ring& ring : shape.rings)
                for (std::uint32_t n = 3 + random.below(12); n > 0; --n)
                    ring.push_back(coarse ? Vec2(random.below(6), random.below(6))
                                          : Vec2(random.uniform(), random.uniform()) * 5);
        }
        Region region;
        try {
            region = fill(shapes);
        } catch (const Error& error) {
            EXPECT_TRUE(coarse) << error.what(); // degenerate: all points on a line
            continue;
        }
        const Region whole = triangulate(region.rings);
        for (int k = 0; k < 500; ++k) {
            const Vec2 p(random.uniform(-0.5, 5.5), random.uniform(-0.5, 5.5));
            const bool inside =
                std::any_of(shapes.begin(), shapes.end(), [&](const FilledRings& shape) {
                    const int number = winding_number(shape.rings, p);
                    return shape.rule == FillRule::nonzero ? number != 0 : number % 2 != 0;
                });
            if (contains(whole, p) != inside) { // up to the separation of touching corners
                EXPECT_LT(std::abs(signed_distance(whole, p)), 2e-4) << i;
            }
        }
    }
}

class SvgRegion : public testing::Test {
  protected:
    Region read(const std::string& body, std::map<std::string, Value> values) {
        write_file(path_, svg(body));
        values["path"] = path_;
        return tests::make(region_table(), "svg", values);
    }

    test::Folder folder_;
    std::string path_ = folder_.file("region.svg");
};

TEST_F(SvgRegion, HasItsSizeAndLiesAboutTheOrigin) {
    const std::string body = "<rect x='100' y='50' width='40' height='20'/>";
    const Box2 box = bounds(read(body, {{"size", 0.08}}));
    EXPECT_NEAR((box.max - Vec2(0.04, 0.02)).length(), 0, 1e-9);
    EXPECT_NEAR((box.min + Vec2(0.04, 0.02)).length(), 0, 1e-9);
    EXPECT_NEAR(area(read(body, {})), 0.5, 1e-6);
    const Box2 there = bounds(read(body, {{"scale", 0.1}, {"centred", false}}));
    EXPECT_NEAR((there.min - Vec2(10, 5)).length(), 0, 1e-6);
    EXPECT_NEAR((there.max - Vec2(14, 7)).length(), 0, 1e-6);
    EXPECT_THROW(read(body, {{"scale", 0.1}, {"size", 1.0}}), Error);
}

TEST_F(SvgRegion, CurvesAreWithinTheTolerance) {
    for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
        const Region region = read("<circle r='50'/>", {{"size", 2.0}, {"tolerance", tolerance}});
        for (const Ring& ring : region.rings)
            for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++)
                EXPECT_LT(std::abs(((ring[i] + ring[j]) / 2).length() - 1), 2.1 * tolerance + 1e-5);
        EXPECT_LT(region.rings[0].size(), 6 / std::sqrt(tolerance));
    }
}

TEST_F(SvgRegion, PathInTheScript) {
    const auto make = [](std::map<std::string, Value> values) {
        return tests::make(region_table(), "path", values);
    };
    EXPECT_NEAR(area(make({{"d", std::string("M0 0h2v3h-2z")}})), 6, 1e-6);
    EXPECT_NEAR(area(make({{"d", std::string("M0 0h2v3h-2z")}, {"size", 6.0}})), 24, 1e-6);
    EXPECT_NEAR(area(make({{"d", std::string("M0 0h4v4h-4zM1 1h2v2h-2z")},
                           {"fill_rule", std::string("evenodd")}})),
                12, 1e-6);
    EXPECT_EQ(tests::error_of([&] {
                  make({{"d", std::string("M0 0L1 1L2 2Z")}});
              }),
              "scene.lua:7: region.path.d: the outline encloses no area");
}

} // namespace
} // namespace scree
