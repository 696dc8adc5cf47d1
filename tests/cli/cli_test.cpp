// SPDX-License-Identifier: GPL-3.0-or-later
// The program as seen by a user: exit codes, messages, files, and results that do not depend on the
// number of threads.
#include "core/file.h"
#include "core/image.h"
#include "geometry/plane/height_field.h"
#include "tests/cli/cli_fixture.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <sys/wait.h>

namespace scree {
namespace {

using tests::Outcome;
namespace fs = std::filesystem;

class Cli : public tests::CliTest {
  protected:
    void SetUp() override {
        CliTest::SetUp();
        write_file(path("small.lua"), small_scene);
    }

    static constexpr const char* small_scene =
        "local seed = arg('seed', 3)\n"
        "return scene {\n"
        "  film = { width = 48, height = 32, samples = 4 },\n"
        "  camera = camera.perspective { from = {0, 1, 1.2}, at = {0, 0, 0}, fov = 40 },\n"
        "  lights = { light.sky {}, light.sun { direction = {1, 2, 1} } },\n"
        "  objects = {\n"
        "    generator.layout {\n"
        "      method = 'fill_gap', seed = seed,\n"
        "      domain = region.rectangle { width = 1, depth = 1 },\n"
        "      components = { { shape = mesh.star {} }, { shape = mesh.banana {} } },\n"
        "    },\n"
        "    object { shape = mesh.plane { size = 4 } },\n"
        "  },\n"
        "}\n";
};

TEST_F(Cli, WithoutACommandItShowsHelpAndFails) {
    const Outcome outcome = run("");
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("render"), std::string::npos);
}

TEST_F(Cli, EveryCommandHasHelpWithAnExample) {
    for (const char* command :
         {"render", "bake", "analyse", "height", "texture", "view", "diff", "check", "list"}) {
        const Outcome outcome = run(std::string(command) + " --help");
        EXPECT_EQ(outcome.code, 0) << command;
        EXPECT_NE(outcome.out.find("Example:\n  scree " + std::string(command)), std::string::npos)
            << outcome.out;
    }
}

TEST_F(Cli, UnknownCommandsAndOptionsGetTheNearestName) {
    Outcome outcome = run("rendr small.lua");
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.err, "unknown command rendr\n  did you mean render?\n");
    outcome = run("render small.lua --sps 4");
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.err, "scree render: unknown option --sps\n  did you mean --spp?\n");
    outcome = run("bake small.lua --ouput=x.json");
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.err, "scree bake: unknown option --ouput\n  did you mean --output?\n");
}

TEST_F(Cli, BadValuesOfOptionsAreUsageErrors) {
    for (const char* arguments :
         {"render small.lua --spp 0", "render small.lua --spp many", "render small.lua --size 0x10",
          "render small.lua --size wide", "render small.lua --crop 0,0,900,900",
          "render small.lua --aov depth", "render small.lua --set seed", "render",
          "render small.lua -o picture.jpg", "analyse small.lua -o report.txt",
          "analyse small.lua --seeds 0", "bake small.lua -o a.png --size 3",
          "bake small.lua -o layout.xyz", "bake small.lua", "view none.exr -o a.tiff",
          "list mesh.banan"}) {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.code, 2) << arguments << "\n" << outcome.err;
        EXPECT_FALSE(outcome.err.empty()) << arguments;
    }
}

TEST_F(Cli, InputErrorsExitWithOne) {
    EXPECT_EQ(run("render none.lua").code, 1);
    EXPECT_EQ(run("render none.lua").err, "none.lua: no such file\n");
    EXPECT_EQ(run("render sky.hdr").err, "sky.hdr: is not a scene; expected .lua or .json\n");
    const Outcome outcome = run("check small.lua --set sed=4");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.err.find("did you mean seed?"), std::string::npos) << outcome.err;
    EXPECT_EQ(run("view small.lua -o a.png").code, 1);
    EXPECT_EQ(run("diff small.lua small.lua").code, 1);
}

TEST_F(Cli, AnUnwritableOutputIsAResourceErrorReportedBeforeRendering) {
    const Outcome outcome = run("render small.lua -o no/such/folder/a.exr");
    EXPECT_EQ(outcome.code, 3);
    EXPECT_EQ(outcome.err, "cannot write no/such/folder/a.exr: no such folder no/such/folder\n");
    EXPECT_EQ(run("bake small.lua -o no/such/a.json").code, 3);
    fs::create_directory(path("folder.exr"));
    EXPECT_EQ(run("render small.lua -o folder.exr").code, 3);
}

TEST_F(Cli, RenderWritesPictureStatsAndMetadata) {
    const Outcome outcome =
        run("render small.lua -o a.exr --aov albedo,N,Z,P,instance,variance --stats s.json");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const ExrFile file = read_exr(path("a.exr"));
    std::vector<std::string> parts;
    for (const ImagePart& part : file.parts)
        parts.push_back(part.name);
    EXPECT_EQ(parts, (std::vector<std::string>{"beauty", "albedo", "N", "Z", "P", "instance",
                                               "variance"}));
    EXPECT_EQ(file.parts[0].image.width, 48);
    bool has_settings = false;
    for (const auto& [name, value] : file.metadata)
        has_settings = has_settings ||
                       (name == "scree:settings" && value.find("fill_gap") != std::string::npos);
    EXPECT_TRUE(has_settings);
    EXPECT_EQ(read_image(path("a.png")).width, 48);

    const auto stats = nlohmann::json::parse(read_file(path("s.json")));
    std::vector<std::string> stages;
    for (const auto& stage : stats["stages"])
        stages.push_back(stage["name"]);
    EXPECT_EQ(stages, (std::vector<std::string>{"parse", "generate", "build", "render", "write"}));
    EXPECT_EQ(stats["render"]["samples_per_pixel"], 4);
    EXPECT_GT(stats["render"]["rays"].get<std::int64_t>(), 48 * 32 * 4);
    EXPECT_EQ(stats["render"]["invalid_samples"], 0);
    EXPECT_GT(stats["generators"][0]["facts"]["count"].get<double>(), 10);
}

TEST_F(Cli, SameSeedSameBytesOnOneAndTwoThreads) {
    ASSERT_EQ(run("bake small.lua -o a.json --threads 1").code, 0);
    ASSERT_EQ(run("bake small.lua -o b.json --threads 2").code, 0);
    EXPECT_EQ(read_file(path("a.json")), read_file(path("b.json")));
    ASSERT_EQ(run("bake small.lua -o c.json --set seed=4").code, 0);
    EXPECT_NE(read_file(path("a.json")), read_file(path("c.json")));

    const std::string aov = " --aov albedo,N,Z,P,instance,variance";
    ASSERT_EQ(run("render small.lua -o a.exr --threads 1" + aov).code, 0);
    ASSERT_EQ(run("render small.lua -o b.exr --threads 2" + aov).code, 0);
    EXPECT_EQ(read_file(path("a.exr")), read_file(path("b.exr")));
    EXPECT_EQ(run("diff a.exr b.exr").code, 0);
    ASSERT_EQ(run("render small.lua -o c.exr --set seed=4").code, 0);
    EXPECT_EQ(run("diff a.exr c.exr").code, 1);
}

TEST_F(Cli, DenoisedIsAFurtherPartAndWhatThePngShows) {
    ASSERT_EQ(run("render small.lua -o raw.exr").code, 0);
    const Outcome outcome =
        run("render small.lua -o a.exr --denoise --crop 5,3,40,20 --stats s.json --aov variance");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE((outcome.out + outcome.err).find("denoised in "), std::string::npos);
    const auto stats = nlohmann::json::parse(read_file(path("s.json")));
    ASSERT_EQ(stats["stages"].size(), 6U);
    EXPECT_EQ(stats["stages"][4]["name"], "denoise");

    ASSERT_EQ(run("render small.lua -o whole.exr --denoise").code, 0);
    const ExrFile raw = read_exr(path("raw.exr"));
    const ExrFile whole = read_exr(path("whole.exr"));
    ASSERT_EQ(whole.parts.size(), 2U);
    EXPECT_EQ(whole.parts[0].name, "beauty");
    EXPECT_EQ(whole.parts[0].image.pixels, raw.parts[0].image.pixels);
    EXPECT_EQ(whole.parts[1].name, "denoised");
    const Image& denoised = whole.parts[1].image;
    EXPECT_EQ(denoised.channels, raw.parts[0].image.channels);
    EXPECT_NE(denoised.pixels, raw.parts[0].image.pixels);
    EXPECT_NE(read_file(path("whole.png")), read_file(path("raw.png")));

    const ExrFile cropped = read_exr(path("a.exr"));
    ASSERT_EQ(cropped.parts.size(), 3U);
    EXPECT_EQ(cropped.parts[1].name, "denoised");
    EXPECT_EQ(cropped.parts[2].name, "variance");
}

TEST_F(Cli, BakedFileHoldsTheBindingKeys) {
    ASSERT_EQ(run("bake small.lua -o a.json").code, 0);
    const auto root = nlohmann::json::parse(read_file(path("a.json")));
    EXPECT_EQ(root["scene"], "small.lua");
    EXPECT_EQ(root["seed"], 3);
    ASSERT_EQ(root["aggregates"].size(), 1U);
    const auto& aggregate = root["aggregates"][0];
    EXPECT_EQ(aggregate["generator"], "layout");
    EXPECT_EQ(aggregate["domain"]["torus"], false);
    EXPECT_EQ(aggregate["prototypes"][1]["name"], "banana");
    EXPECT_GT(aggregate["prototypes"][0]["region"].size(), 0U);
    EXPECT_EQ(aggregate["facts"]["count"], aggregate["instances"].size());
    // The matrix agrees with position, angle and scale up to rounding to float.
    for (const auto& instance : aggregate["instances"]) {
        const auto& m = instance["matrix"];
        ASSERT_EQ(m.size(), 12U);
        const double angle = instance["angle"].get<double>() * 3.14159265358979323846 / 180;
        const double scale = instance["scale"];
        EXPECT_NEAR(m[0].get<double>(), scale * std::cos(angle), 1e-5);
        EXPECT_NEAR(m[8].get<double>(), scale * std::sin(angle), 1e-5);
        EXPECT_NEAR(m[5].get<double>(), scale, 1e-5);
    }
}

TEST_F(Cli, BakeDrawsTheLayoutFromAbove) {
    ASSERT_EQ(run("bake small.lua -o a.svg").code, 0);
    ASSERT_EQ(run("bake small.lua -o a.png --size 300").code, 0);
    ASSERT_EQ(run("bake small.lua -o a.json").code, 0);
    const std::string svg = read_file(path("a.svg"));
    const auto root = nlohmann::json::parse(read_file(path("a.json")));
    std::size_t uses = 0;
    for (std::size_t at = 0; (at = svg.find("<use ", at)) != std::string::npos; ++at)
        ++uses;
    EXPECT_EQ(uses, root["aggregates"][0]["instances"].size());
    const Image image = read_image(path("a.png"));
    EXPECT_EQ(image.width, 300);
    EXPECT_EQ(image.height, 300);
    const Outcome outcome = run("bake small.lua -o layout.xyz");
    EXPECT_EQ(
        outcome.err,
        "layout.xyz: cannot bake to .xyz; expected one of .json, .svg, .png, .exr, .stl, .3mf\n");
}

TEST_F(Cli, AnalyseOfASceneEqualsThatOfItsBakedFile) {
    ASSERT_EQ(run("analyse small.lua -o a.json").code, 0);
    ASSERT_EQ(run("bake small.lua -o baked.json").code, 0);
    ASSERT_EQ(run("analyse baked.json -o b.json --threads 1").code, 0);
    auto a = nlohmann::json::parse(read_file(path("a.json")));
    auto b = nlohmann::json::parse(read_file(path("b.json")));
    EXPECT_EQ(a["source"], "small.lua");
    a.erase("source");
    b.erase("source");
    EXPECT_EQ(a, b);
    const auto& report = a["aggregates"][0];
    const auto baked = nlohmann::json::parse(read_file(path("baked.json")))["aggregates"][0];
    EXPECT_EQ(report["layouts"][0]["count"], baked["instances"].size());
    EXPECT_NEAR(report["layouts"][0]["fill"].get<double>(), baked["facts"]["fill"].get<double>(),
                1e-5);
    EXPECT_GT(report["layouts"][0]["largest_empty_circle"]["radius"].get<double>(), 0);
    EXPECT_GT(read_image(path("a.png")).width, 1000);
}

TEST_F(Cli, AnalyseAveragesOverSeeds) {
    ASSERT_EQ(run("analyse small.lua -o a.json --seeds 3").code, 0);
    const auto report = nlohmann::json::parse(read_file(path("a.json")))["aggregates"][0];
    ASSERT_EQ(report["layouts"].size(), 3U);
    EXPECT_EQ(report["layouts"][0]["seed"], 3);
    EXPECT_EQ(report["layouts"][2]["seed"], 5);
    EXPECT_NE(report["layouts"][0]["fill"], report["layouts"][1]["fill"]);
}

TEST_F(Cli, AnalyseReportsErrors) {
    write_file(path("bad.json"), "{\"aggregates\": [{\"generator\": \"g\"}]}");
    Outcome outcome = run("analyse bad.json -o a.json");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_EQ(outcome.err, "bad.json: aggregates[0].prototypes: is missing\n");
    write_file(path("empty.json"), "{\"aggregates\": []}");
    outcome = run("analyse empty.json -o a.json");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_EQ(outcome.err,
              "empty.json: there is nothing to analyse; expected a generator with a domain\n");
    outcome = run("analyse empty.json -o a.json --seeds 2");
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.err, "--seeds needs a scene: empty.json holds one layout\n");
    EXPECT_EQ(run("analyse none.json -o a.json").err, "none.json: no such file\n");
    EXPECT_EQ(run("analyse small.lua -o no/such/a.json").code, 3);
}

TEST_F(Cli, TheSameSceneAsJsonGivesTheSamePicture) {
    const Outcome outcome = run("check small.lua --json");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    write_file(path("small.json"), outcome.out);
    ASSERT_EQ(run("render small.lua -o a.exr").code, 0);
    ASSERT_EQ(run("render small.json -o b.exr").code, 0);
    EXPECT_EQ(run("diff a.exr b.exr").code, 0);
    EXPECT_EQ(run("check small.json --json").out, outcome.out);
}

TEST_F(Cli, ViewHonoursViewsExposureAndOcio) {
    ASSERT_EQ(run("render small.lua -o a.exr").code, 0);
    ASSERT_EQ(run("view a.exr -o dark.png --exposure -2").code, 0);
    ASSERT_EQ(run("view a.exr -o light.png --view standard").code, 0);
    EXPECT_LT(read_image(path("dark.png")).at(24, 28)[1],
              read_image(path("light.png")).at(24, 28)[1]);
    const Outcome outcome = run("view a.exr -o x.png --view filmc");
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.err,
              "unknown view 'filmc'; there are: filmic, standard, raw\n  did you mean filmic?\n");
    const Outcome bad = run("view a.exr -o x.png", "OCIO=none.ocio");
    EXPECT_EQ(bad.code, 1);
    EXPECT_NE(bad.err.find("none.ocio"), std::string::npos);
}

TEST_F(Cli, ListShowsEveryParameterFromItsDeclaration) {
    const Outcome all = run("list");
    EXPECT_EQ(all.code, 0);
    for (const char* name :
         {"mesh.banana", "mesh.file", "region.rectangle", "generator.layout", "material.glass",
          "light.sun", "camera.perspective", "procedural.checker", "scene", "object"})
        EXPECT_NE(all.out.find(name), std::string::npos) << name;
    const Outcome one = run("list generator.layout");
    EXPECT_EQ(one.code, 0);
    for (const char* text : {"naive | fill_gap", "components[].margin", "required", "default"})
        EXPECT_NE(one.out.find(text), std::string::npos) << text << "\n" << one.out;
    EXPECT_EQ(run("list mesh.banan").err, "scree list: nothing is called mesh.banan\n"
                                          "  did you mean mesh.banana?\n");
}

// When this fails: ./scree list --markdown > docs/reference.md
TEST_F(Cli, ReferencePageIsUpToDate) {
    EXPECT_EQ(run("list --markdown").out,
              read_file(std::string(SCREE_SOURCE_DIR) + "/docs/reference.md"));
}

TEST_F(Cli, HeightWritesTheMapInMetres) {
    write_file(path("leather.lua"),
               "local tile = { preset = arg('preset', 'pebbled'), size = 0.04, resolution = 64,\n"
               "  triangles = 100, seed = arg('seed', 3) }\n"
               "return scene { objects = { generator.leather(tile) } }\n");
    Outcome outcome = run("height leather.lua -o a.exr --stats s.json");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const HeightField map = read_height(path("a.exr"));
    EXPECT_EQ(map.image.width, 64);
    EXPECT_EQ(map.size, Vec2(0.04F, 0.04F));
    EXPECT_EQ(map.mid_level, 0);
    EXPECT_TRUE(map.tiles);
    const auto [low, high] = std::minmax_element(map.image.pixels.begin(), map.image.pixels.end());
    const Image picture = read_image(path("a.png")); // a picture to look at
    EXPECT_EQ(picture.width, 64);
    EXPECT_LT(*std::min_element(picture.pixels.begin(), picture.pixels.end()), 0.01F);
    EXPECT_GT(*std::max_element(picture.pixels.begin(), picture.pixels.end()), 0.98F);
    EXPECT_GT(*high - *low, 3e-4F);
    EXPECT_LT(*high - *low, 1e-3F);
    EXPECT_GT(nlohmann::json::parse(read_file(path("s.json")))["generators"][0]["facts"]["cells"]
                  .get<int>(),
              50);

    ASSERT_EQ(run("height leather.lua -o b.exr --threads 1").code, 0);
    EXPECT_EQ(read_file(path("a.exr")), read_file(path("b.exr"))) << "on any number of threads";
    ASSERT_EQ(run("height leather.lua -o c.exr --set seed=4").code, 0);
    EXPECT_NE(read_image(path("c.exr")).pixels, map.image.pixels);

    ASSERT_EQ(run("height leather.lua -o v.exr --vector").code, 0);
    const HeightField vectors = read_height(path("v.exr"));
    EXPECT_TRUE(vectors.is_vector());
    EXPECT_EQ(vectors.as_height().image.pixels, map.image.pixels);
    ASSERT_EQ(run("height leather.lua -o r.exr --vector --set preset=reptile").code, 0);
    const HeightField leaning = read_height(path("r.exr"));
    EXPECT_NE(*std::max_element(leaning.image.pixels.begin(), leaning.image.pixels.end()),
              leaning.image.pixels[1]);
    EXPECT_NE(leaning.offset({0.31, 0.47}).x, 0) << "shoulders lean over the grooves";
}

TEST_F(Cli, HeightReportsErrors) {
    write_file(path("two.lua"), "local g = generator.leather { size = 0.03, resolution = 16,\n"
                                "  triangles = 100 }\n"
                                "return scene { objects = { g, g } }\n");
    Outcome outcome = run("height small.lua -o a.exr --quiet");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_EQ(outcome.err, "small.lua: scene.objects: no generator has a height map; expected a "
                           "generator.leather\n");
    outcome = run("height two.lua -o a.exr --quiet");
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.err, "two.lua has 2 height maps; choose one\n"
                           "  for example --index 1, counted in the order of scene.objects, or "
                           "--object NAME\n");
    outcome = run("height two.lua -o a.exr --index 3 --quiet");
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.err, "--index 3: two.lua has 2 height maps\n");
    EXPECT_EQ(run("height two.lua -o a.exr --index 2").code, 0);
    EXPECT_EQ(run("height two.lua -o a.png").code, 2);
    EXPECT_EQ(run("height two.lua -o no/such/a.exr").code, 3);
    EXPECT_FALSE(fs::exists(path("no")));
}

} // namespace
} // namespace scree
