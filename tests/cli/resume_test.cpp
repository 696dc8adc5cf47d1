// SPDX-License-Identifier: GPL-3.0-or-later
// Renders that are interrupted, continued and shared among machines.
#include "core/image.h"
#include "tests/cli/cli_fixture.h"

#include <filesystem>

namespace scree {
namespace {

using tests::Outcome;

class ResumeCli : public tests::CliTest {
  protected:
    ResumeCli() {
        write("small.lua", 0.5);
        write("other.lua", 0.6);
    }

    void write(const std::string& name, double grey) const {
        write_file(path(name), "return scene { film = { width = 70, height = 40, samples = 12 },\n"
                               "camera = camera.perspective { from = {0, 1, 3}, at = {0, 0, 0} },\n"
                               "lights = { light.sky { group = \"day\" }, light.sun {} },\n"
                               "objects = { object { shape = mesh.sphere { radius = 0.5 },\n"
                               "  material = material.matte { color = { " +
                                   std::to_string(grey) + ", 0.4, 0.3 } } } } }");
    }
    bool exists(const std::string& name) const { return std::filesystem::exists(path(name)); }
    void expect_same(const std::string& a, const std::string& b) const {
        EXPECT_TRUE(read_file(path(a)) == read_file(path(b))) << a << " and " << b;
    }
};

// Nothing is finished in a tenth of a second with as many samples, on any machine.
constexpr const char* unfinished = "render small.lua --quiet --spp 16000000 --time 0.1 -o ";

TEST_F(ResumeCli, AnUnfinishedRenderLeavesACheckpointAndAFinishedOneDoesNot) {
    EXPECT_EQ(run("render small.lua --quiet -o whole.exr").code, 0);
    EXPECT_FALSE(exists("whole.checkpoint"));
    EXPECT_EQ(run(std::string(unfinished) + "a.exr").code, 0);
    EXPECT_TRUE(exists("a.checkpoint"));
    const Outcome again = run("render small.lua -o a.exr");
    EXPECT_NE(again.err.find("warning: a.checkpoint of an interrupted render will be overwritten; "
                             "--resume would continue it"),
              std::string::npos)
        << again.err;
    EXPECT_FALSE(exists("a.checkpoint"));
    expect_same("a.exr", "whole.exr");
}

TEST_F(ResumeCli, AFinishedRenderGoesOnForMoreSamples) {
    EXPECT_EQ(run("render small.lua --quiet --spp 32 --aov variance -o whole.exr").code, 0);
    const Outcome first = run("render small.lua --resume --spp 12 -o a.exr");
    EXPECT_NE(first.err.find("a.checkpoint is not there: the render begins anew"),
              std::string::npos);
    EXPECT_TRUE(exists("a.checkpoint"));
    const Outcome second = run("render small.lua --resume --spp 32 --aov variance -o a.exr");
    EXPECT_NE(second.err.find("resumes a.checkpoint at 12.0 samples per pixel"), std::string::npos)
        << second.err;
    expect_same("a.exr", "whole.exr");
    expect_same("a.png", "whole.png");
}

TEST_F(ResumeCli, ACheckpointOfAnotherPictureIsRefused) {
    EXPECT_EQ(run(std::string(unfinished) + "a.exr").code, 0);
    const std::string anew = "\n  to begin anew, delete it or render without --resume\n";
    const auto refused = [&](const std::string& arguments, const std::string& message) {
        const Outcome outcome = run("render --quiet --resume -o a.exr " + arguments);
        EXPECT_EQ(outcome.code, 1);
        EXPECT_EQ(outcome.err, "a.checkpoint: is of another picture: " + message + anew);
    };
    refused("small.lua --seed 3", "seed 0 instead of seed 3");
    refused("small.lua --size 40x40", "size 70x40 instead of size 40x40");
    refused("small.lua --crop 0,0,9,9", "crop 0,0,70,40 instead of crop 0,0,9,9");
    refused("small.lua --shard 2/3", "shard 1/1 instead of shard 2/3");
    refused("small.lua --aov crypto_object", "mattes no instead of mattes yes");
    EXPECT_EQ(run("render --quiet --resume -o a.exr other.lua").code, 1);
    const std::string bytes = read_file(path("a.checkpoint"));
    write_file(path("a.checkpoint"), bytes.substr(0, bytes.size() / 2));
    EXPECT_EQ(run("render small.lua --quiet --resume -o a.exr").err,
              "a.checkpoint: is not the state of a picture of this size" + anew);
    write_file(path("a.checkpoint"), "something");
    EXPECT_EQ(run("render small.lua --quiet --resume -o a.exr").err,
              "a.checkpoint: is not a checkpoint of this version of Scree" + anew);
}

TEST_F(ResumeCli, ShardsMergeToTheBytesOfTheWhole) {
    const std::string how =
        " --quiet --aov albedo,instance,variance,crypto_object --view standard --png-bits 16";
    for (const auto& [more, counts] : {std::pair{"", std::vector{1, 16}},
                                       {" --crop 3,5,60,30", {3}},
                                       {" --noise 0.05 --spp 64", {3}}}) {
        const std::string render = "render small.lua" + how + more;
        EXPECT_EQ(run(render + " -o whole.exr").code, 0);
        for (const int count : counts) {
            std::string parts;
            for (int i = 1; i <= count; ++i) {
                const std::string name = "s" + std::to_string(i) + ".exr";
                parts = name + " " + parts;
                EXPECT_EQ(run(render + " --shard " + std::to_string(i) + "/" +
                              std::to_string(count) + " -o " + name)
                              .code,
                          0);
            }
            EXPECT_EQ(run("merge " + parts + "-o merged.exr").code, 0);
            expect_same("merged.exr", "whole.exr");
            expect_same("merged.png", "whole.png");
        }
    }
}

TEST_F(ResumeCli, MergeRefusesWhatDoesNotBelongTogether) {
    const auto shard = [&](const std::string& name, const std::string& arguments) {
        EXPECT_EQ(run("render --quiet -o " + name + " " + arguments).code, 0);
    };
    shard("a.exr", "small.lua --shard 1/2");
    shard("b.exr", "small.lua --shard 2/2");
    shard("whole.exr", "small.lua");
    shard("third.exr", "small.lua --shard 2/3");
    shard("seed.exr", "small.lua --shard 2/2 --seed 1");
    shard("scene.exr", "other.lua --shard 2/2");
    shard("size.exr", "small.lua --shard 2/2 --size 40x40");
    shard("parts.exr", "small.lua --shard 2/2 --aov N");
    const auto refused = [&](const std::string& parts, const std::string& message) {
        const Outcome outcome = run("merge -o m.exr " + parts);
        EXPECT_EQ(outcome.code, 1);
        EXPECT_EQ(outcome.err, message + "\n");
        EXPECT_FALSE(exists("m.exr"));
    };
    refused("a.exr", "of 2 shards, these are missing: 2");
    refused("a.exr a.exr", "a.exr: is the same shard as a.exr");
    refused("a.exr whole.exr",
            "whole.exr: is not a shard\n  shards are made by scree render --shard I/N");
    refused("a.exr third.exr", "third.exr: is one of 3 shards, but a.exr is one of 2");
    refused("a.exr seed.exr",
            "seed.exr: is of another picture than a.exr: their scree:render_seed differ");
    refused("a.exr scene.exr",
            "scene.exr: is of another picture than a.exr: their scree:hash differ");
    refused("a.exr size.exr", "size.exr: has another size, crop or other parts than a.exr");
    refused("a.exr parts.exr", "parts.exr: has another size, crop or other parts than a.exr");
}

} // namespace
} // namespace scree
