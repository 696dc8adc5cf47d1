// SPDX-License-Identifier: GPL-3.0-or-later
// Options beside the scene's name, names of objects, crops, and scenes far from the origin.
#include "core/image.h"
#include "tests/cli/cli_fixture.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstring>

namespace scree {
namespace {

using tests::Outcome;
namespace fs = std::filesystem;

class OptionsCli : public tests::CliTest {
  protected:
    void SetUp() override {
        CliTest::SetUp();
        write_file(path("named.lua"), named_scene);
        write_file(path("far.lua"), far_scene);
    }

    static constexpr const char* named_scene =
        "local seed = arg('seed', 3)\n"
        "local stripes = material.matte { color = procedural.checker {} }\n"
        "return scene {\n"
        "  film = { width = 24, height = 16, samples = 1 },\n"
        "  camera = camera.perspective { from = {0, 1, 1.2}, fov = 40 },\n"
        "  lights = { light.sky {} },\n"
        "  objects = {\n"
        "    generator.layout {\n"
        "      name = 'sweets', seed = seed, domain = region.rectangle { width = 1, depth = 1 },\n"
        "      components = { { shape = mesh.star {}, margin = arg('margin', 0.0) } } },\n"
        "    object { shape = mesh.plane { size = 4 }, name = 'floor', material = stripes },\n"
        "    object { shape = mesh.sphere {}, name = 'ball', material = stripes },\n"
        "    object { shape = mesh.box {}, name = 'ball', material = stripes },\n"
        "  },\n"
        "}\n";

    static constexpr const char* far_scene =
        "local o = arg('o', 0.0)\n"
        "return scene {\n"
        "  film = { width = 64, height = 48, samples = 64 },\n"
        "  camera = camera.perspective { from = {o, o + 0.15, 0.3 - o}, at = {o, o + 0.02, -o},\n"
        "                                fov = 35 },\n"
        "  lights = { light.area { position = {o, o + 0.5, -o}, at = {o, o, -o},\n"
        "                          size = {0.3, 0.3} } },\n"
        "  objects = {\n"
        "    object { shape = mesh.plane { size = 4 }, position = {o, o, -o},\n"
        "             material = material.matte { color = procedural.checker { size = 0.02 } } },\n"
        "    generator.pile { target = mesh.sphere { radius = 0.03 }, position = {o, o, -o},\n"
        "                     components = { { shape = mesh.box { width = 0.01 } } } },\n"
        "  },\n"
        "}\n";
};

TEST_F(OptionsCli, RepeatableOptionsDoNotSwallowTheScene) {
    for (const char* arguments :
         {"check --set seed=4 named.lua", "check --set seed=4 --set margin=0.01 named.lua",
          "render --aov N named.lua -o a.exr", "render --aov N,Z named.lua -o a.exr",
          "render --set=seed=4 --aov=N named.lua -o a.exr"}) {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.code, 0) << arguments << "\n" << outcome.err;
    }
    EXPECT_EQ(read_exr(path("a.exr")).parts.size(), 2U);
}

TEST_F(OptionsCli, WithoutLightThereIsNoPicture) {
    write_file(path("dark.lua"),
               "return scene { camera = camera.perspective { from = {0, 1, 2} },\n"
               "  objects = { object { shape = mesh.sphere {} } } }\n");
    const Outcome outcome = run("render dark.lua -o a.exr");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_EQ(outcome.err,
              "dark.lua: scene.lights: are missing; without light the picture is black\n"
              "  for example lights = { light.sky {}, light.sun {} }\n");
    EXPECT_FALSE(fs::exists(path("a.exr")));
    write_file(path("black.lua"),
               "return scene { camera = camera.perspective { from = {0, 1, 2} },\n"
               "  lights = { light.sky { strength = 0 }, light.sun { color = 0 } },\n"
               "  objects = { object { shape = mesh.sphere {} } } }\n");
    EXPECT_EQ(run("render black.lua -o a.exr").err,
              "black.lua: scene.lights: are all black, and so is the picture\n"
              "  expected a strength and a color above 0\n");
    EXPECT_EQ(
        run("check black.lua").err,
        "warning: black.lua: scene.lights: all black: scree bake can do without, scree render "
        "cannot\n  expected a strength and a color above 0\n");
    const Outcome checked = run("check dark.lua"); // it can be baked
    EXPECT_EQ(checked.code, 0);
    EXPECT_EQ(checked.err,
              "warning: dark.lua: scene.lights: missing: scree bake can do without, scree render "
              "cannot\n  for example lights = { light.sky {}, light.sun {} }\n");
    EXPECT_EQ(run("check named.lua").err, "");
}

TEST_F(OptionsCli, DrawingsWarnOfProceduralsTheyDoNotShow) {
    write_file(path("striped.lua"),
               "local stripes = material.matte { color = procedural.checker {} }\n"
               "local function tile(name, paint)\n"
               "  return generator.layout { name = name,\n"
               "    domain = region.rectangle { width = 0.4, depth = 0.4 },\n"
               "    components = { { shape = mesh.star {}, material = paint },\n"
               "                   { shape = mesh.heart {}, material = paint },\n"
               "                   { shape = mesh.box {}, material = material.matte {} } } }\nend\n"
               "return scene { objects = { tile('plain'), tile('striped', stripes) } }\n");
    for (const char* file : {"a.svg", "a.png", "a.exr"}) {
        const Outcome outcome = run(std::string("bake striped.lua -o ") + file);
        EXPECT_EQ(outcome.code, 0);
        const std::size_t at = outcome.err.find("warning: ");
        ASSERT_NE(at, std::string::npos) << file << outcome.err;
        EXPECT_EQ(outcome.err.substr(at, outcome.err.find('\n', at) - at),
                  "warning: striped.lua:3: generator.layout \"striped\": a drawing has one flat "
                  "colour for each component: the procedural of star, heart is not shown");
        EXPECT_EQ(outcome.err.find("warning: ", at + 1), std::string::npos) << outcome.err;
    }
    EXPECT_EQ(run("bake striped.lua -o a.json").err.find("warning: "), std::string::npos);
}

TEST_F(OptionsCli, TheSizeOfADrawingIsThatOfItsLongerSide) {
    for (const std::string size : {"300x300", "3", "big", "300.5"}) {
        const Outcome outcome = run("bake named.lua -o a.png --size " + size);
        EXPECT_EQ(outcome.code, 2);
        EXPECT_EQ(outcome.err,
                  "scree bake: --size: expected one number of pixels from 16 to 32768, for the "
                  "longer side of the .png or .exr, whose form is that of the layout; got " +
                      size + "\n  see scree bake --help\n");
    }
}

TEST_F(OptionsCli, ADrawingOfNothingNamesItsFile) {
    write_file(path("wool.lua"),
               "return scene { objects = { generator.fibres { count = 8, contact = false,\n"
               "  target = mesh.sphere { radius = 0.05 } } } }\n");
    for (const std::string file : {"a.svg", "a.png", "a.exr"}) {
        const Outcome outcome = run("bake wool.lua -o " + file);
        EXPECT_EQ(outcome.code, 1);
        EXPECT_NE(outcome.err.find(file + ": there is nothing to see from above: no generator has "
                                          "a domain, regions or pictures\n"),
                  std::string::npos)
            << outcome.err;
    }
}

TEST_F(OptionsCli, OneOfAThingIsNotSeveral) {
    write_file(path("one.lua"), "return scene { lights = { light.sky {} },\n"
                                "  camera = camera.perspective { from = {0, 1, 2} },\n"
                                "  objects = { object { shape = mesh.sphere {} } } }\n");
    EXPECT_EQ(run("check one.lua").out,
              "one.lua: no mistakes: 0 generators, 1 object, 1 light, 1280 x 720 pixels\n");
}

TEST_F(OptionsCli, AnOptionIsNotTakenForAFile) {
    for (const std::string command : {"render", "bake", "height", "texture"}) {
        const Outcome outcome = run(command + " named.lua --stats -o a.exr");
        EXPECT_EQ(outcome.code, 2);
        EXPECT_EQ(outcome.err,
                  fmt::format("scree {0}: --stats: expected the name of a file, got -o; a file of "
                              "this name is ./-o\n  see scree {0} --help\n",
                              command));
    }
    for (const char* arguments : {"analyse named.lua -o --seeds 2", "view a.exr -o --exposure 1"}) {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.code, 2) << arguments;
        EXPECT_NE(outcome.err.find("expected the name of a file, got --"), std::string::npos)
            << outcome.err;
    }
    EXPECT_EQ(run("bake named.lua -o a.json --stats ./-o").code, 0);
    EXPECT_TRUE(fs::exists(path("-o")));
}

TEST_F(OptionsCli, HeightAsksBeforeItMakesAMap) {
    write_file(path("maps.lua"),
               "local function tile(name, size)\n"
               "  return generator.leather { name = name, size = size, resolution = 16,\n"
               "    triangles = 3000 }\nend\n"
               "return scene { objects = { object { shape = mesh.box {}, name = 'box' },\n"
               "  tile('calf', 0.03), tile('hide', 0.04) } }\n");
    const Outcome asked = run("height maps.lua -o a.exr");
    EXPECT_EQ(asked.code, 2);
    EXPECT_EQ(asked.err, "maps.lua has 2 height maps; choose one\n  for example --index 1, counted "
                         "in the order of scene.objects, or --object NAME\n");
    const auto made = [&](const std::string& option) {
        const Outcome outcome = run("height maps.lua -o a.exr " + option);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        EXPECT_EQ(outcome.err.find("leather \""), outcome.err.rfind("leather \""))
            << "one is made: " << outcome.err;
        return read_exr(path("a.exr")).numbers;
    };
    EXPECT_EQ(made("--index 2"), made("--object hide"));
    EXPECT_EQ(made("--index 2"), made("--object 3"));
    EXPECT_NE(made("--index 1"), made("--object hide"));
    EXPECT_EQ(run("height maps.lua -o a.exr --object box").err,
              "maps.lua:5: object: has no height map; expected a generator.leather\n");
    EXPECT_EQ(run("height maps.lua -o a.exr --object hid").err,
              "--object hid: expected the name of an object of maps.lua, or a number from 1 to 3\n"
              "  did you mean hide?\n");
    EXPECT_EQ(run("height maps.lua -o a.exr --object hide --index 1").code, 2);
}

TEST_F(OptionsCli, PartsOfAPictureAreSaidAndChosen) {
    ASSERT_EQ(run("render named.lua -o a.exr --aov N,albedo").code, 0);
    ASSERT_EQ(run("render named.lua -o b.exr --aov albedo").code, 0);
    ASSERT_EQ(run("bake named.lua -o layout.exr --size 24").code, 0);
    EXPECT_EQ(run("view a.exr -o a.png").err,
              "shows the first part of a.exr; its parts are: beauty, albedo, N\n");
    const std::string beauty = read_file(path("a.png"));
    EXPECT_EQ(run("view a.exr -o a.png --part N").err, "");
    EXPECT_NE(read_file(path("a.png")), beauty);
    EXPECT_EQ(run("view a.exr -o a.png --part n").err,
              "a.exr: has no part n; there are: beauty, albedo, N\n  did you mean N?\n");
    EXPECT_EQ(run("view layout.exr -o a.png").err, "") << "it has one part";

    EXPECT_EQ(run("diff a.exr b.exr").out,
              "compares the part beauty; a.exr has: beauty, albedo, N\n"
              "rmse 0, largest 0 at (0, 0), pixels identical\n");
    EXPECT_EQ(run("diff a.exr b.exr --part albedo").code, 0);
    EXPECT_EQ(run("diff a.exr b.exr --part N").err,
              "b.exr: has no part N; there are: beauty, albedo\n");
    EXPECT_EQ(run("diff a.exr layout.exr").code, 1) << "of other sizes";
}

/// The four numbers of a window in the header of an EXR: left, top, right, bottom.
std::array<std::int32_t, 4> window_of(const std::string& exr, const std::string& name) {
    const std::string key = name + '\0' + "box2i" + '\0';
    const std::size_t at = exr.find(key);
    std::array<std::int32_t, 4> window{};
    if (at != std::string::npos)
        std::memcpy(window.data(), exr.data() + at + key.size() + 4, sizeof window);
    return window;
}

TEST_F(OptionsCli, ACropKeepsItsPlaceInThePicture) {
    ASSERT_EQ(run("render named.lua -o whole.exr --spp 4").code, 0);
    ASSERT_EQ(run("render named.lua -o crop.exr --spp 4 --crop 5,3,10,8").code, 0);
    const std::string bytes = read_file(path("crop.exr"));
    EXPECT_EQ(window_of(bytes, "displayWindow"), (std::array<std::int32_t, 4>{0, 0, 23, 15}));
    EXPECT_EQ(window_of(bytes, "dataWindow"), (std::array<std::int32_t, 4>{5, 3, 14, 10}));
}

TEST_F(OptionsCli, NamesAreShown) {
    ASSERT_EQ(run("bake named.lua -o a.json --stats stats.json").code, 0);
    EXPECT_NE(run("bake named.lua -o b.json").err.find("layout \"sweets\": "), std::string::npos);
    const auto baked = nlohmann::json::parse(read_file(path("a.json")));
    EXPECT_EQ(baked["aggregates"][0]["name"], "sweets");
    const auto stats = nlohmann::json::parse(read_file(path("stats.json")));
    EXPECT_EQ(stats["generators"][0]["name"], "sweets");
    ASSERT_EQ(run("analyse a.json -o report.json").code, 0);
    const auto report = nlohmann::json::parse(read_file(path("report.json")))["aggregates"][0];
    EXPECT_EQ(report["name"], "sweets");
    const Outcome outcome = run("check named.lua --set margin=-1");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.err.find("generator.layout \"sweets\".components[1].margin"),
              std::string::npos)
        << outcome.err;
}

TEST_F(OptionsCli, ReportsHoldWhatTheirCurvesArePlottedOver) {
    ASSERT_EQ(run("analyse named.lua -o report.json").code, 0);
    const auto report = nlohmann::json::parse(read_file(path("report.json")))["aggregates"][0];
    const auto& power = report["radial_power"];
    ASSERT_GT(power["f"].size(), 4U);
    EXPECT_EQ(power["f"].size(), power["power"].size());
    EXPECT_EQ(power["counts"].size(), power["power"].size());
    EXPECT_FALSE(power.contains("frequencies"));
    EXPECT_NEAR(power["f"][3].get<double>(), 3.5 * power["bin_width"].get<double>(), 1e-9);
    const auto& pairs = report["pair_correlation"];
    EXPECT_EQ(pairs["r"].size(), pairs["g"].size());
    EXPECT_NEAR(pairs["r"][2].get<double>(), 2.5 * pairs["bin_width"].get<double>(), 1e-9);
}

TEST_F(OptionsCli, ShapesAndMarginsAreDrawnApart) {
    ASSERT_EQ(run("bake named.lua --set margin=0.02 -o margins.svg").code, 0);
    ASSERT_EQ(run("bake named.lua --set margin=0.02 -o margins.json").code, 0);
    ASSERT_EQ(run("bake named.lua -o bare.svg").code, 0);
    EXPECT_NE(read_file(path("margins.svg")).find("class=\"margins\""), std::string::npos);
    EXPECT_EQ(read_file(path("bare.svg")).find("class=\"margins\""), std::string::npos);
    const auto star =
        nlohmann::json::parse(read_file(path("margins.json")))["aggregates"][0]["prototypes"][0];
    const auto right_end = [](const nlohmann::json& rings) {
        double most = 0;
        for (const auto& point : rings[0])
            most = std::max(most, point[0].get<double>());
        return most;
    };
    EXPECT_GT(right_end(star["region"]), right_end(star["outline"]) + 0.015);
}

TEST_F(OptionsCli, TexturesAreOfTheNamedObject) {
    const std::string arguments = "texture named.lua -o a.png --size 32 --object ";
    EXPECT_EQ(run(arguments + "floor").code, 0);
    EXPECT_EQ(run(arguments + "2").code, 0);
    Outcome outcome = run(arguments + "ball");
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.err, "--object ball: the objects 3 and 4 have this name\n"
                           "  choose one by its number\n");
    outcome = run(arguments + "flor");
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.err,
              "--object flor: expected the name of an object of named.lua, or a number "
              "from 1 to 4\n  did you mean floor?\n");
    EXPECT_EQ(run(arguments + "5").code, 2);
}

TEST_F(OptionsCli, ASceneLooksTheSameFarFromTheOrigin) {
    ASSERT_EQ(run("render far.lua -o near.exr --aov P").code, 0);
    const Image near = read_image(path("near.exr"));
    for (const double o : {1e3, 1e4, 1e5}) {
        const Outcome outcome =
            run("render far.lua -o far.exr --aov P --set o=" + std::to_string(o));
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        const ExrFile file = read_exr(path("far.exr"));
        const Image& far = file.parts[0].image;
        // The same samples meet the same surfaces: all but a few at edges are equal.
        std::size_t different = 0;
        for (std::size_t i = 0; i < near.pixels.size(); ++i)
            different += std::abs(near.pixels[i] - far.pixels[i]) > 0.02F + 0.02F * near.pixels[i];
        EXPECT_LT(different, near.pixels.size() / 50) << o;
        EXPECT_NEAR(double(file.parts[1].image.at(32, 40)[0]), o, 0.3) << o;
    }
}

TEST_F(OptionsCli, ViewShowsAnEnvironmentPicture) {
    const std::string pixel{char(128), 64, 0, char(129)}; // red 1, green 0.5, in shared exponents
    write_file(path("sky.hdr"), "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n" + pixel);
    ASSERT_EQ(run("view sky.hdr -o sky.png --view raw").code, 0);
    const Image shown = read_data_image(path("sky.png"));
    EXPECT_NEAR(shown.at(0, 0)[0], 1.0F, 0.01F);
    EXPECT_NEAR(shown.at(0, 0)[1], 0.5F, 0.01F);
    EXPECT_NEAR(shown.at(0, 0)[2], 0.0F, 0.01F);
}

TEST_F(OptionsCli, NumbersThatMakeNoSenseAreRefused) {
    const auto refused = [&](const std::string& option, const std::string& value,
                             const std::string& expected) {
        const Outcome outcome = run("render named.lua --quiet " + option + " " + value);
        EXPECT_EQ(outcome.code, 2);
        EXPECT_EQ(outcome.err, "scree render: " + option + ": expected " + expected + "; got " +
                                   value + "\n  see scree render --help\n");
    };
    for (const char* value : {"nan", "inf", "0", "-1", "1e999", "2s"}) {
        refused("--time", value, "a number above 0");
        refused("--noise", value, "a number above 0");
    }
    for (const char* value : {"-1", "18446744073709551616", "99999999999999999999", "1.5", "x"})
        refused("--seed", value, "a whole number from 0 to 18446744073709551615");
    refused("--seed", "+1", "a whole number from 0 to 18446744073709551615");
}

} // namespace
} // namespace scree
