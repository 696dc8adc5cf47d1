// SPDX-License-Identifier: GPL-3.0-or-later
// `scree bake` to files for 3D printers: outputs and messages.
#include "tests/cli/cli_fixture.h"

#include <nlohmann/json.hpp>

namespace scree {
namespace {

namespace fs = std::filesystem;
using tests::Outcome;

class SolidCli : public tests::CliTest {
  protected:
    void SetUp() override {
        CliTest::SetUp();
        write_file(path("balls.lua"), scene);
    }

    static constexpr const char* scene =
        "local shapes = { ball = mesh.sphere { radius = 0.01 }, sheet = mesh.plane { size = 0.01 } "
        "}\n"
        "return scene { objects = {\n"
        "  generator.elements { domain = region.rectangle { width = 0.1, depth = 0.1 },\n"
        "    components = { { shape = shapes[arg('shape', 'ball')] } } },\n"
        "  object { shape = mesh.plane {} } } }\n";
};

TEST_F(SolidCli, PartsAndFilesAgreeWithTheStats) {
    const Outcome outcome =
        run("bake balls.lua -o a.stl --resolution 1mm --parts keep --stats a.json");
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto solid = nlohmann::json::parse(read_file(path("a.json"))).at("solid");
    // Balls that almost touch are merged at this resolution.
    EXPECT_GT(solid.at("parts").size(), 10U);
    EXPECT_LE(solid.at("parts").size(), solid.at("components"));
    EXPECT_EQ(solid.at("resolution_mm"), 1);
    EXPECT_EQ(fs::file_size(path("a.stl")), 84 + 50 * solid.at("triangles").get<std::size_t>());
    const Outcome printed = run("bake balls.lua -o a.3mf --resolution 0.001");
    EXPECT_EQ(printed.code, 0);
    EXPECT_NE(printed.err.find(" not connected with the largest: "), std::string::npos);
    EXPECT_TRUE(read_file(path("a.3mf")).starts_with("PK"));
}

TEST_F(SolidCli, SheetsAreNamedOrLeftOut) {
    const Outcome stopped = run("bake balls.lua --set shape=sheet -o a.stl --quiet");
    EXPECT_EQ(stopped.code, 1);
    EXPECT_EQ(stopped.err,
              "balls.lua:3: generator.elements: plane is not closed: it has 4 boundary edges\n"
              "  close it in a modelling program, or leave it out with --open skip\n");
    const Outcome skipped = run("bake balls.lua --set shape=sheet -o a.stl --open skip --quiet");
    EXPECT_EQ(skipped.code, 1);
    EXPECT_EQ(skipped.err, "there is no closed component to make a solid of\n");
    EXPECT_FALSE(fs::exists(path("a.stl")));
}

} // namespace
} // namespace scree
