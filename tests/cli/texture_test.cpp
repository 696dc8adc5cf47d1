// SPDX-License-Identifier: GPL-3.0-or-later
// `scree texture`: outputs, messages, and that a baked texture looks like its procedural.
#include "core/display_encoding.h"
#include "core/image.h"
#include "geometry/plane/height_field.h"
#include "tests/cli/cli_fixture.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace scree {
namespace {

using tests::Outcome;

class TextureCli : public tests::CliTest {
  protected:
    void SetUp() override {
        CliTest::SetUp();
        write_file(path("checker.lua"), checker_scene);
        write_file(path("marble.lua"), marble_scene);
    }

    void expect_error(const std::string& arguments, int code, const std::string& message) const {
        const Outcome outcome = run("texture " + arguments + " --quiet");
        EXPECT_EQ(outcome.code, code) << arguments;
        EXPECT_EQ(outcome.err, message) << arguments;
    }

    // The color is a checker or, with --set picture=FILE, a picture on the mesh's UVs.
    static constexpr const char* checker_scene =
        "local picture = arg('picture', '')\n"
        "local color = picture == '' and procedural.checker { size = 0.07 }\n"
        "  or procedural.image { path = picture, repeats = true }\n"
        "local shapes = { sphere = mesh.sphere { radius = 0.1 }, torus = mesh.torus { radius = 0.1 "
        "},\n"
        "  plane = mesh.plane { size = 0.25 }, box = mesh.box { width = 0.15 } }\n"
        "return scene {\n"
        "  film = { width = 96, height = 72, samples = 32 },\n"
        "  camera = camera.perspective { from = {0.1, 0.25, 0.3}, at = {0, 0.06, 0}, fov = 40 },\n"
        "  lights = { light.sky {} },\n"
        "  objects = { object { shape = shapes[arg('shape', 'sphere')],\n"
        "                       material = material.matte { color = color } } },\n"
        "}\n";

    static constexpr const char* marble_scene =
        "local marble = procedural.marble { vein_height = 0.001, filler_roughness = 0.2,\n"
        "  vein_roughness = 0.6 }\n"
        "local shape = mesh.box { width = 0.2, height = 0.1, depth = 0.05 }\n"
        "local plain = object { shape = mesh.plane {} }\n"
        "return scene { objects = {\n"
        "  plain,\n"
        "  object { shape = mesh.plane { size = 0.2 },\n"
        "           material = material.plastic { color = marble } },\n"
        "  object { shape = shape, position = { 1, 0, 0 },\n"
        "           material = material.matte { color = marble } },\n"
        "  object { shape = mesh.file { path = 'flat.obj' },\n"
        "           material = material.matte { color = marble } },\n"
        "  object { shape = shape, material = material.plastic {\n"
        "           color = procedural.image { path = 'white.png' } } },\n"
        "  generator.layout { domain = region.rectangle { width = 0.1, depth = 0.1 }, seed = 1,\n"
        "    components = { { shape = mesh.star {}, material = material.matte { color = marble } "
        "},\n"
        "                   { shape = mesh.rice {}, material = material.matte { color = marble } } "
        "} },\n"
        "} }\n";
};

class MarbleCli : public TextureCli {
  protected:
    void SetUp() override {
        TextureCli::SetUp();
        write_file(path("flat.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        Image white(4, 4, {"R", "G", "B"});
        std::fill(white.pixels.begin(), white.pixels.end(), 1.0F);
        write_png(path("white.png"), white);
    }
};

double difference(const Image& a, const Image& b) {
    EXPECT_EQ(a.pixels.size(), b.pixels.size());
    double sum = 0;
    for (std::size_t i = 0; i < std::min(a.pixels.size(), b.pixels.size()); ++i)
        sum += std::pow(double(a.pixels[i]) - double(b.pixels[i]), 2);
    return std::sqrt(sum / double(a.pixels.size()));
}

const Image& part(const ExrFile& file, const std::string& name) {
    const auto found = std::find_if(file.parts.begin(), file.parts.end(),
                                    [&](const ImagePart& p) { return p.name == name; });
    EXPECT_NE(found, file.parts.end()) << name;
    return found->image;
}

TEST_F(TextureCli, ABakedCheckerLooksLikeTheChecker) {
    for (const std::string shape : {"plane", "sphere", "torus"}) {
        const std::string set = " --set shape=" + shape;
        ASSERT_EQ(run("render checker.lua -o a.exr --aov albedo" + set).code, 0);
        Image first = part(read_exr(path("a.exr")), "albedo");
        for (const std::string texture : {"t.exr", "t.png"}) {
            const Outcome baked = run("texture checker.lua --size 1024x768 -o " + texture + set);
            ASSERT_EQ(baked.code, 0) << baked.err;
            EXPECT_EQ(baked.err, "wrote " + texture + "\n");
            ASSERT_EQ(
                run("render checker.lua -o b.exr --aov albedo --set picture=" + texture + set).code,
                0);
            EXPECT_LT(difference(first, part(read_exr(path("b.exr")), "albedo")), 0.02)
                << shape << " as " << texture;
        }
    }
}

TEST_F(TextureCli, SaysWhenUvsOverlap) {
    const Outcome outcome = run("texture checker.lua -o a.png --size 64 --set shape=box");
    EXPECT_EQ(outcome.code, 0);
    EXPECT_NE(outcome.err.find("warning: UVs of box overlap: "), std::string::npos) << outcome.err;
}

TEST_F(TextureCli, SaysWhenTheProceduralDoesNotGiveTheChannel) {
    for (const std::string channel : {"height", "normal"}) {
        const Outcome outcome = run("texture checker.lua -o a.exr --size 16 --channel " + channel);
        EXPECT_EQ(outcome.code, 0);
        EXPECT_TRUE(outcome.err.starts_with(
            "warning: the " + channel + " is the same everywhere: this procedural gives none\n"))
            << outcome.err;
    }
}

TEST_F(TextureCli, PngIsDisplayEncodedForColoursOnly) {
    ASSERT_EQ(run("texture checker.lua -o a.png --size 64").code, 0);
    ASSERT_EQ(run("texture checker.lua -o a.exr --size 64").code, 0);
    const ExrFile exr = read_exr(path("a.exr"));
    ASSERT_EQ(exr.parts.size(), 1U);
    EXPECT_EQ(exr.parts[0].name, "color");
    EXPECT_LT(difference(read_image(path("a.png")), exr.parts[0].image), 0.005);
}

TEST_F(MarbleCli, WritesEveryChannel) {
    const std::string plane = "texture marble.lua --object 2 --size 96x64 ";
    for (const std::string channel : {"roughness", "value"}) {
        ASSERT_EQ(run(plane + "-o a.exr --channel " + channel).code, 0);
        ASSERT_EQ(run(plane + "-o a.png --channel " + channel).code, 0);
        const Image exr = part(read_exr(path("a.exr")), channel);
        EXPECT_EQ(exr.channels, std::vector<std::string>{"Y"});
        EXPECT_LT(difference(read_data_image(path("a.png")), exr), 0.005) << "linear";
        const auto [low, high] = std::minmax_element(exr.pixels.begin(), exr.pixels.end());
        EXPECT_GE(*low, 0);
        EXPECT_LE(*high, 1);
        EXPECT_GT(*high - *low, 0.05F);
    }
    const Outcome outcome = run(plane + "-o h.exr --channel height --stats s.json");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const HeightField height = read_height(path("h.exr"));
    EXPECT_EQ(height.image.width, 96);
    EXPECT_EQ(height.image.height, 64);
    EXPECT_NEAR(height.size.x, 0.2, 1e-6);
    EXPECT_NEAR(height.size.y, 0.2, 1e-6);
    EXPECT_FALSE(height.tiles);
    const auto [low, high] =
        std::minmax_element(height.image.pixels.begin(), height.image.pixels.end());
    EXPECT_GT(*high - *low, 1e-4F);
    EXPECT_LE(*high, 1e-3F + 1e-6F);
    const auto stats = nlohmann::json::parse(read_file(path("s.json")));
    EXPECT_EQ(stats["texture"]["covered"], 96 * 64);
    EXPECT_EQ(stats["texture"]["overlapped"], 0);

    // The normal map agrees with the height map where that has enough pixels to resolve its veins.
    const std::string fine = "texture marble.lua --object 2 --size 600 ";
    ASSERT_EQ(run(fine + "-o h.exr --channel height").code, 0);
    ASSERT_EQ(run(fine + "-o n.exr --channel normal").code, 0);
    const Image heights = read_height(path("h.exr")).image;
    const Image normals = part(read_exr(path("n.exr")), "normal");
    double product = 0, ours = 0, theirs = 0;
    for (int y = 1; y < 599; ++y)
        for (int x = 1; x < 599; ++x) {
            const float* n = normals.at(x, y);
            const double lean = -(double(n[1]) * 2 - 1) / (double(n[2]) * 2 - 1);
            const double rise =
                double(*heights.at(x, y - 1) - *heights.at(x, y + 1)) / (2 * 0.2 / 600);
            product += lean * rise;
            ours += lean * lean;
            theirs += rise * rise;
        }
    EXPECT_GT(product / std::sqrt(ours * theirs), 0.8) << "green points to where v grows";
    EXPECT_NEAR(product / theirs, 1, 0.2);
}

TEST_F(MarbleCli, WritesSlicesAndVolumes) {
    const std::string box = "texture marble.lua --object 3 ";
    ASSERT_EQ(run(box + "-o a.exr --map slices --slices 6 --axis x --size 40").code, 0);
    const ExrFile slices = read_exr(path("a.exr"));
    ASSERT_EQ(slices.parts.size(), 6U);
    EXPECT_EQ(slices.parts[0].name, "slice_1_x_-0.083333");
    EXPECT_EQ(slices.parts[0].image.width, 20);
    EXPECT_EQ(slices.parts[0].image.height, 40);
    const auto number = [&](const std::string& name) {
        for (const auto& [key, values] : slices.numbers)
            if (key == name)
                return values;
        return std::vector<float>{};
    };
    ASSERT_EQ(number("sliceStep").size(), 3U);
    EXPECT_NEAR(number("sliceStep")[0], 0.2 / 6, 1e-6);
    EXPECT_NEAR(number("sliceDown")[1], -0.1 / 40, 1e-7);

    ASSERT_EQ(run(box + "-o a.png --map slices --slices 6 --size 40").code, 0);
    const Image sheet = read_image(path("a.png")); // 40 x 20 pixels each
    EXPECT_EQ(sheet.width, 2 * 40 + 4);
    EXPECT_EQ(sheet.height, 3 * 20 + 2 * 4);

    Outcome outcome = run(box + "-o v.exr --map volume --size 16 --axis y");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "box is closed: 512 of 512 voxels are inside\nwrote v.exr\n");
    const ExrFile volume = read_exr(path("v.exr"));
    ASSERT_EQ(volume.parts.size(), 8U);
    EXPECT_EQ(volume.parts[0].image.channels, (std::vector<std::string>{"R", "G", "B", "A"}));

    ASSERT_EQ(run(box + "-o a.vdb --size 20 --threads 1").code, 0);
    ASSERT_EQ(run(box + "-o b.vdb --size 20 --threads 2").code, 0);
    EXPECT_EQ(read_file(path("a.vdb")), read_file(path("b.vdb")));
    EXPECT_NE(read_file(path("a.vdb")).find("density"), std::string::npos);
    outcome = run("texture marble.lua --object 4 -o a.vdb --size 8");
    EXPECT_EQ(outcome.err,
              "flat.obj is not closed: the whole of its bounding box is filled\nwrote a.vdb\n");
}

TEST_F(MarbleCli, ReportsErrorsInTheScene) {
    expect_error("none.lua -o a.png", 1, "none.lua: no such file\n");
    write_file(path("plain.lua"),
               "return scene { objects = { object { shape = mesh.box {} } } }\n");
    expect_error("plain.lua -o a.png", 1,
                 "plain.lua: scene.objects: no object has a procedural; expected a material whose "
                 "color is a procedural.*\n  scree list shows what there is\n");
    expect_error("marble.lua -o a.png", 2,
                 "marble.lua: the objects 2, 3, 4, 5, 6 have a procedural; choose one\n"
                 "  for example --object 2, counted in the order of scene.objects, or its name\n");
    expect_error("marble.lua -o a.png --object 7", 2,
                 "--object 7: expected the name of an object of marble.lua, or a number from 1 to "
                 "6\n");
    expect_error("marble.lua -o a.png --object 1", 1,
                 "marble.lua:4: object.material: object 1 has no procedural; expected a material "
                 "whose color is a procedural.*\n");
    expect_error("marble.lua -o a.png --object 4", 1,
                 "marble.lua:11: object.shape: flat.obj has no UVs, so a texture has no place on "
                 "it\n  unwrap it in a modelling program, or use --map slices or --map volume\n");
    expect_error("marble.lua -o a.vdb --object 5", 1,
                 "marble.lua:13: object.material: this procedural lies on the surface and has no "
                 "inside; expected a solid one\n  use --map uv\n");
    expect_error("marble.lua -o a.png --object 6", 1,
                 "marble.lua:15: generator.layout: 2 of its components have a procedural; a "
                 "texture is of one\n  put the one you want into an object { shape, material }\n");
    expect_error("checker.lua -o a.png --channel roughness", 1,
                 "checker.lua:10: object.material: neither the procedural nor the material has a "
                 "roughness\n  material.plastic, metal and translucent have one\n");
    write_file(path("flat.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n");
    expect_error("marble.lua -o a.png --object 4", 1,
                 "marble.lua:11: object.shape: flat.obj has UVs without any area, so a texture has "
                 "no place on it\n  unwrap it in a modelling program\n");
}

TEST_F(MarbleCli, RefusesInvalidCombinations) {
    expect_error("marble.lua -o a.jpg", 2,
                 "a.jpg: expected a name that ends in .png, .exr or .vdb\n");
    expect_error("marble.lua -o a.vdb --map uv", 2,
                 "--map uv: a .vdb holds a volume\n  write a .png or .exr\n");
    expect_error("marble.lua -o a.png --map volume", 2,
                 "a.png: a volume is written as .vdb or .exr\n  or see --map slices\n");
    expect_error("marble.lua -o a.png --map slcies", 2,
                 "--map slcies: expected one of uv, slices, volume\n  did you mean slices?\n");
    expect_error("marble.lua -o a.vdb --channel value", 2,
                 "--channel: a .vdb holds the grids density (value) and color\n  leave it away\n");
    expect_error("marble.lua -o a.exr --map slices --channel normal", 2,
                 "--channel normal: a normal map lies over UVs\n  use --map uv\n");
    expect_error("marble.lua -o a.png --channel height", 2,
                 "a.png: heights in metres do not fit into a .png\n  write an .exr\n");
    expect_error("marble.lua -o a.png --slices 4", 2, "--slices is for --map slices, not uv\n");
    expect_error("marble.lua -o a.vdb --axis x", 2,
                 "--axis is for --map slices, and for volumes as .exr\n  leave it away\n");
    for (const std::string size : {"0", "-4", "12x", "3x4x5", "20000", "wide", "8x0"})
        expect_error("marble.lua -o a.png --size " + size, 2,
                     "--size " + size +
                         ": expected N or WxH pixels, 1 to 16384\n"
                         "  for example --size 2048\n");
    expect_error("marble.lua -o a.vdb --size 2000", 2,
                 "--size 2000: expected a number of voxels along the longest side, 1 to 1024\n"
                 "  for example --size 128\n");
    expect_error("marble.lua -o no/such/a.vdb", 3,
                 "cannot write no/such/a.vdb: no such folder no/such\n");
}

} // namespace
} // namespace scree
