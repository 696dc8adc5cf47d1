// SPDX-License-Identifier: GPL-3.0-or-later
// Strands that scripts and files give.
#include "core/file.h"
#include "formats/table.h"
#include "geometry/mesh/strand_spline.h"
#include "shapes/table.h"
#include "tests/support/errors.h"
#include "tests/support/folder.h"
#include "tests/support/plugin_params.h"
#include "tests/support/strands.h"

#include <gtest/gtest.h>

namespace scree {
namespace {

const std::vector<Vec3> bend{{0, 0, 0}, {0, 1, 0}, {0.5F, 1.5F, 0}, {1.5F, 1.5F, 0.5F}};

Strands made(const std::string& name, const std::map<std::string, Value>& values) {
    return tests::make(curve_table(), name, values);
}

TEST(Curve, PolylineKeepsItsPoints) {
    const Strands line =
        made("polyline", {{"points", bend}, {"radius", std::vector<double>{0.1, 0.2, 0.3, 0.4}}});
    EXPECT_EQ(line.name, "polyline");
    EXPECT_EQ(line.kind, CurveKind::linear);
    EXPECT_EQ(line.points, bend);
    EXPECT_EQ(line.radii, (std::vector<float>{0.1F, 0.2F, 0.3F, 0.4F}));
    EXPECT_EQ(line.offsets, (std::vector<std::uint32_t>{0, 4}));
    EXPECT_EQ(line.segment_count(), 3U);
    ASSERT_EQ(line.normals.size(), 1U);
    EXPECT_NEAR(line.normals[0].dot(Vec3(0, 1, 0)), 0, 1e-6F);
}

TEST(Curve, SplinePassesThroughItsPoints) {
    const Strands spline = made("spline", {{"points", bend}});
    EXPECT_EQ(spline.kind, CurveKind::bspline);
    EXPECT_EQ(spline.segment_count(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_LT((test::spline_point(&spline.points[i], 0) - bend[i]).length(), 1e-6F);
        EXPECT_LT((test::spline_point(&spline.points[i], 1) - bend[i + 1]).length(), 1e-6F);
        for (const float u : {0.2F, 0.7F})
            EXPECT_LT(
                (test::spline_point(&spline.points[i], u) - spline_point(&spline.points[i], u))
                    .length(),
                1e-6F);
    }
    // Its ends are parabolas.
    for (const std::size_t i : {std::size_t(0), std::size_t(2)})
        EXPECT_LT((spline.points[i + 3] - spline.points[i + 2] * 3.0F +
                   spline.points[i + 1] * 3.0F - spline.points[i])
                      .length(),
                  1e-5F);
    EXPECT_EQ(spline.radii, std::vector<float>(6, 0.001F)) << "the default";
}

TEST(Curve, ManyStrandsInOneShape) {
    std::vector<Params> list;
    for (int i = 0; i < 3; ++i) {
        Params& strand = list.emplace_back("curve.spline.strands[]", Location{"scene.lua", 9});
        strand.set("points", std::vector<Vec3>(bend.begin(), bend.begin() + 2 + i % 2));
        strand.set("radius", std::vector<double>{0.01});
    }
    const Strands strands =
        made("spline", {{"strands", std::make_shared<const std::vector<Params>>(list)}});
    EXPECT_EQ(strands.offsets, (std::vector<std::uint32_t>{0, 4, 9, 13}));
    EXPECT_EQ(strands.segment_count(), 4U);
    ASSERT_EQ(strands.randoms.size(), 3U);
    EXPECT_NE(strands.randoms[0], strands.randoms[1]);
}

TEST(Curve, ChainsBecomeSplines) {
    Random random(51, Purpose::test);
    Strands chains = test::random_chains(random, 20, 32, 0.1F, 0.02F, 0.1F);
    chains.randoms.assign(20, 0.5F);
    const Strands curves = splined(chains);
    EXPECT_EQ(curves.count(), 20U);
    EXPECT_EQ(curves.segment_count(), 20U * 11);
    EXPECT_EQ(curves.randoms, chains.randoms);
    for (std::size_t i = 0; i < 20; ++i) {
        const Vec3* first = &curves.points[curves.offsets[i]];
        const Vec3* last = &curves.points[curves.offsets[i + 1] - 4];
        EXPECT_LT((spline_point(first, 0) - chains.points[chains.offsets[i]]).length(), 1e-5F);
        EXPECT_LT((spline_point(last, 1) - chains.points[chains.offsets[i + 1] - 1]).length(),
                  1e-5F);
    }
    // An arc of 3 degrees a segment, of 5 radii each: the spline is far nearer than a chord.
    Strands arc;
    std::vector<Vec3> points;
    for (int i = 0; i <= 32; ++i) {
        const double turn = radians(3) * i;
        points.emplace_back(static_cast<float>(std::cos(turn)), static_cast<float>(std::sin(turn)),
                            0.0F);
    }
    test::add_strand(arc, points, std::vector<float>(33, 0.01F));
    EXPECT_LT(spline_deviation(arc, splined(arc)), 0.05);
    EXPECT_NEAR(spline_deviation(arc, splined(arc, 1)), 0, 1e-4);
    // Every vertex is one that the spline passes but two, whose distance is known.
    Strands kinked;
    test::add_strand(kinked, {{0, 0, 0}, {1, 0.3F, 0}, {2, 0.3F, 0}, {3, 0, 0}},
                     std::vector<float>(4, 0.1F));
    EXPECT_NEAR(spline_deviation(kinked, splined(kinked)), 3, 1e-3) << "a straight line";
}

TEST(Curve, RadiiOfASplineAreNeverNegative) {
    Strands strands;
    strands.kind = CurveKind::bspline;
    const std::vector<float> radii{0.1F, 0.0F, 0.1F, 0.0F};
    add_spline(strands, bend, radii);
    for (const float radius : strands.radii)
        EXPECT_GE(radius, 0);
}

class CurveFile : public testing::Test {
  protected:
    std::string path(const std::string& name) const { return folder.file(name); }
    Strands read(const std::string& name, const std::string& text,
                 const std::map<std::string, Value>& more = {}) const {
        write_file(path(name), text);
        std::map<std::string, Value> values = more;
        values["path"] = path(name);
        return tests::make(curve_file_table(), "file", values);
    }
    std::string error(const std::string& name, const std::string& text) const {
        const std::string all = tests::error_of([&] { read(name, text); });
        const std::size_t at = all.find(name);
        return at == std::string::npos ? all : all.substr(at);
    }

    test::Folder folder;
};

const std::string corners = "v 0 0 0\nv 0 1 0\nv 0 2 0\nv 1 2 0\nv 5 5 5\nv 6 6 6\n";

TEST_F(CurveFile, LinesOfAnObjFile) {
    // The second line goes on with the first, which has a point twice.
    const Strands strands =
        read("a.obj", corners + "l 1 2 2 3\nl 3 4\nl -2 -1\nf 1 2 4\n", {{"radius", 0.25}});
    EXPECT_EQ(strands.name, "a.obj");
    EXPECT_EQ(strands.offsets, (std::vector<std::uint32_t>{0, 4, 6}));
    EXPECT_EQ(strands.points[3], Vec3(1, 2, 0));
    EXPECT_EQ(strands.points[5], Vec3(6, 6, 6));
    EXPECT_EQ(strands.radii, std::vector<float>(6, 0.25F));
    EXPECT_EQ(strands.normals.size(), 2U);
    EXPECT_EQ(strands.randoms.size(), 2U);
    const Strands smooth =
        read("a.obj", corners + "l 1 2 3 4\n", {{"curve", std::string("bspline")}});
    EXPECT_EQ(smooth.kind, CurveKind::bspline);
    EXPECT_EQ(smooth.segment_count(), 3U);
}

TEST_F(CurveFile, StrandsOfABakedFile) {
    const Strands strands =
        read("b.json", R"({"aggregates": [{"generator": "fibres", "prototypes": [{"name": "hair"}],
                     "strands": [{"points": [[0,0,0],[1,0,0]], "radius": [0.1, 0.2]},
                                 {"points": [[0,0,5],[1,0,5],[2,0,5]], "radius": [1,1,1]}]}]})");
    EXPECT_EQ(strands.kind, CurveKind::linear);
    EXPECT_EQ(strands.offsets, (std::vector<std::uint32_t>{0, 2, 5}));
    EXPECT_EQ(strands.radii[1], 0.2F);
}

TEST_F(CurveFile, ArePlacedAsMeshesAre) {
    const std::string line = "v 9 9 9\nv 100 200 0\nv 300 200 1000\nl 2 3\n"; // v 9 9 9 is unused
    const std::map<std::string, Value> millimetres{{"unit", std::string("mm")}};
    const Strands scaled = read("a.obj", line, millimetres);
    EXPECT_EQ(scaled.points[1], Vec3(0.3F, 0.2F, 1));
    EXPECT_EQ(scaled.radii[1], 0.001F);
    const Strands turned = read("a.obj", line, {{"up", std::string("z")}, {"size", 2.0}});
    EXPECT_EQ(turned.points[0], Vec3(-0.2F, 0, 0));
    EXPECT_EQ(turned.points[1], Vec3(0.2F, 2, 0));
    EXPECT_EQ(turned.radii[1], 0.001F);

    const std::string baked =
        R"({"aggregates": [{"generator": "fibres", "prototypes": [{"name": "hair"}],
        "strands": [{"points": [[1,1,0],[5,1,0]], "radius": [0.5, 0.5]}]}]})";
    const Strands half = read("b.json", baked, {{"size", 2.0}});
    EXPECT_EQ(half.points[0], Vec3(-1, 0, 0));
    EXPECT_EQ(half.points[1], Vec3(1, 0, 0));
    EXPECT_EQ(half.radii[0], 0.25F);
    EXPECT_NE(tests::error_of([&] {
                  read("b.json", baked, millimetres);
              }).find("curve.file.unit: a baked scene is in metres"),
              std::string::npos);
}

TEST_F(CurveFile, Errors) {
    EXPECT_EQ(error("a.obj", corners), "a.obj: it has no lines (l)");
    EXPECT_EQ(error("a.obj", corners + "l 1 9\n"), "a.obj: line 7: a line names vertex 9 of 6");
    EXPECT_EQ(error("a.obj", corners + "l 1\n"),
              "a.obj: line 7: a line has 1 corner; expected at least 2");
    EXPECT_EQ(error("a.obj", corners + "l 1 x\n"),
              "a.obj: line 7: \"x\" is not a corner of a line; expected whole numbers");
    EXPECT_EQ(error("a.json", "{\"aggregates\": []}"), "a.json: it has no strands");
    EXPECT_EQ(error("a.json", "{\n\n\"aggregates\": [,"), "a.json: line 3: is not JSON");
    EXPECT_EQ(error("a.json", "{\"aggregates\": [{}]}"),
              "a.json: aggregates[0].generator is missing");
    EXPECT_EQ(error("a.abc", ""), "a.abc: is not a file of curves; expected .obj or .json");
}

} // namespace
} // namespace scree
