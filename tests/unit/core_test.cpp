// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/error.h"
#include "core/file.h"
#include "core/located.h"
#include "core/parallel.h"
#include "core/random.h"
#include "core/registry.h"
#include "geometry/mesh/mesh.h"
#include "geometry/plane/region.h"
#include "tests/support/folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sys/stat.h>

namespace scree {
namespace {

namespace fs = std::filesystem;

class FolderTest : public testing::Test {
  protected:
    std::string path(const std::string& name) const { return folder_.file(name); }

    test::Folder folder_;
};

std::string message_of(const std::function<void()>& body) {
    try {
        body();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

TEST(ErrorText, NamesFileLinePathAndHint) {
    const Error error(Diagnostic{{"gravel.lua", 14},
                                 "generator.rocks.radius",
                                 "25 m is out of range; expected 0.0001 to 1 m",
                                 "did you mean mm(25)?"});
    EXPECT_STREQ(error.what(), "gravel.lua:14: generator.rocks.radius: 25 m is out of range; "
                               "expected 0.0001 to 1 m\n  did you mean mm(25)?");
    EXPECT_EQ(error.fault(), Fault::input);
}

TEST(ErrorText, ListsAllDiagnostics) {
    const Error error(Fault::input, {{{"a.lua", 1}, "", "one", ""}, {{"a.lua", 2}, "", "two", ""}});
    EXPECT_STREQ(error.what(), "a.lua:1: one\na.lua:2: two");
}

TEST(NearestName, FindsTyposAndRejectsUnrelatedNames) {
    const std::vector<std::string> names{"radius", "rotation", "scale", "seed"};
    EXPECT_EQ(nearest_name("raduis", names), "radius"); // a transposition
    EXPECT_EQ(nearest_name("rotatoin", names), "rotation");
    EXPECT_EQ(nearest_name("sed", names), "seed");
    EXPECT_EQ(nearest_name("thickness", names), "");
    EXPECT_EQ(did_you_mean("scael", names), "did you mean scale?");
    EXPECT_EQ(did_you_mean("x", names), ""); // one letter is near to everything
}

TEST(NearestName, IgnoresCaseAndSeparators) {
    const std::vector<std::string> names{"x", "y", "z", "thin_film"};
    EXPECT_EQ(nearest_name("Z", names), "z");
    EXPECT_EQ(nearest_name("ThinFilm", names), "thin_film");
    EXPECT_EQ(nearest_name("thin-film", names), "thin_film");
}

TEST(NearestName, KnowsOtherWordsForTheSameThing) {
    const std::vector<std::string> shapes{"disk", "sphere", "box", "plane", "torus"};
    EXPECT_EQ(nearest_name("circle", shapes), "disk");
    EXPECT_EQ(nearest_name("Cube", shapes), "box");
    EXPECT_EQ(nearest_name("ball", shapes), "sphere");
    EXPECT_EQ(nearest_name("donut", shapes), "torus");
    EXPECT_EQ(nearest_name("centre", std::vector<std::string>{"center"}), "center");
    EXPECT_EQ(nearest_name("tetrahedron", shapes), "");
}

TEST(NearestName, CompletesTheOnlyNameThatBeginsSo) {
    const std::vector<std::string> names{"roughness", "rotation", "resolution"};
    EXPECT_EQ(nearest_name("rough", names), "roughness");
    EXPECT_EQ(nearest_name("ro", names), ""); // two begin so, and it is short
}

// Known answers of the Random123 distribution (kat_vectors: philox4x32 10).
TEST(RandomNumbers, PhiloxKnownAnswers) {
    r123::Philox4x32 philox;
    const auto zero = philox({{0, 0, 0, 0}}, {{0, 0}});
    EXPECT_EQ(zero.v[0], 0x6627e8d5U);
    EXPECT_EQ(zero.v[1], 0xe169c58dU);
    EXPECT_EQ(zero.v[2], 0xbc57ac4cU);
    EXPECT_EQ(zero.v[3], 0x9b00dbd8U);
    const auto digits =
        philox({{0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}}, {{0xa4093822, 0x299f31d0}});
    EXPECT_EQ(digits.v[0], 0xd16cfe09U);
    EXPECT_EQ(digits.v[1], 0x94fdccebU);
}

TEST(RandomNumbers, StreamsDifferByPurposeIndexAndSeed) {
    const std::uint32_t base = Random(1, Purpose::test, 5).bits();
    EXPECT_EQ(base, Random(1, Purpose::test, 5).bits());
    EXPECT_NE(base, Random(2, Purpose::test, 5).bits());
    EXPECT_NE(base, Random(1, Purpose::test, 6).bits());
    EXPECT_NE(base, Random(1, Purpose::layout_dart, 5).bits());
    EXPECT_NE(base, Random(1ULL << 32, Purpose::test, 5).bits());
}

// Chi-square with 99 degrees of freedom: 148.2 is its 99.9th percentile.
TEST(RandomNumbers, BelowIsUniform) {
    Random random(3, Purpose::test);
    std::vector<int> counts(100);
    const int draws = 100000;
    for (int i = 0; i < draws; ++i)
        ++counts[random.below(100)];
    double chi2 = 0;
    for (const int count : counts)
        chi2 += (count - 1000.0) * (count - 1000.0) / 1000.0;
    EXPECT_LT(chi2, 148.2);
    EXPECT_GT(chi2, 61.1); // 0.1th percentile: too regular is wrong too
}

TEST(RandomNumbers, UniformStaysInHalfOpenInterval) {
    Random random(4, Purpose::test);
    double sum = 0;
    for (int i = 0; i < 100000; ++i) {
        const double x = random.uniform();
        const float y = random.uniform_float();
        ASSERT_TRUE(x >= 0 && x < 1 && y >= 0 && y < 1);
        sum += x;
    }
    EXPECT_NEAR(sum / 100000, 0.5, 5 / std::sqrt(12.0 * 100000)); // five sigma
}

Mesh cube() {
    Mesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.positions.emplace_back(float(i & 1), float((i >> 1) & 1), float(i >> 2));
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

TEST(MeshFactsTest, CubeIsClosedWithVolumeAndArea) {
    const Mesh mesh = cube();
    EXPECT_TRUE(inspect(mesh).closed());
    EXPECT_NEAR(volume(mesh), 1, 1e-12);
    EXPECT_NEAR(area(mesh), 6, 1e-12);
}

TEST(MeshFactsTest, FindsHolesFlipsAndSlivers) {
    Mesh open = cube();
    open.triangles.pop_back();
    EXPECT_EQ(inspect(open).boundary_edges, 3U);
    Mesh flipped = cube();
    std::swap(flipped.triangles[0][0], flipped.triangles[0][1]);
    EXPECT_EQ(inspect(flipped).non_manifold_edges, 3U);
    Mesh sliver = cube();
    sliver.triangles.push_back({0, 0, 1});
    EXPECT_EQ(inspect(sliver).degenerate_triangles, 1U);
}

TEST(MeshNormals, CreaseSplitsACubeAndSmoothingDoesNot) {
    Mesh sharp = cube();
    compute_normals(sharp, radians(40));
    EXPECT_EQ(sharp.positions.size(), 24U);
    EXPECT_TRUE(inspect(sharp).closed());
    for (const Vec3& n : sharp.normals)
        EXPECT_NEAR(std::abs(n.x) + std::abs(n.y) + std::abs(n.z), 1, 1e-6);
    Mesh smooth = cube();
    compute_normals(smooth, radians(120));
    EXPECT_EQ(smooth.positions.size(), 8U);
    EXPECT_NEAR(smooth.normals[7].dot(Vec3(1, 1, 1).normalized()), 1, 1e-6);
}

TEST(MeshTransform, MirroringKeepsOutwardNormals) {
    Mesh mesh = cube();
    Matrix mirror;
    mirror.setScale(Vec3(-2, 1, 1));
    transform(mesh, mirror);
    EXPECT_NEAR(volume(mesh), 2, 1e-6);
    normalise_size(mesh, 0.5);
    EXPECT_NEAR(bounds(mesh).size().x, 0.5, 1e-6);
    EXPECT_EQ(bounds(mesh).min.y, 0);
    EXPECT_NEAR(bounds(mesh).center().x, 0, 1e-6);
}

TEST(RegionFacts, AreaInsideAndDistanceOfASquareWithAHole) {
    Region region;
    region.rings = {{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{1, 1}, {1, 3}, {3, 3}, {3, 1}}};
    EXPECT_DOUBLE_EQ(area(region), 12);
    EXPECT_TRUE(contains(region, {0.5, 2}));
    EXPECT_FALSE(contains(region, {2, 2}));
    EXPECT_FALSE(contains(region, {5, 2}));
    EXPECT_DOUBLE_EQ(signed_distance(region, {0.25, 2}), -0.25);
    EXPECT_DOUBLE_EQ(signed_distance(region, {2, 2}), 1);
    EXPECT_DOUBLE_EQ(signed_distance(region, {7, 8}), 5);
}

TEST(LocatedErrors, PlaceInputFaultsAndLeaveOthersAsTheyAre) {
    Params params("generator.layout", {"scene.lua", 7});
    params.set("epsilon", 0.1, {"scene.lua", 9});
    const auto fails = [] { throw Error("is too small"); };
    EXPECT_EQ(message_of([&] { located(params, "epsilon", fails); }),
              "scene.lua:9: generator.layout.epsilon: is too small");
    EXPECT_EQ(message_of([&] { located(params, "scale", fails); }),
              "scene.lua:7: generator.layout.scale: is too small");
    EXPECT_EQ(message_of([&] { located(params, fails); }),
              "scene.lua:7: generator.layout: is too small");
    try {
        located(params.place("epsilon"), [] { throw Error::resource("out of memory"); });
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.fault(), Fault::resource);
        EXPECT_STREQ(error.what(), "out of memory");
    }
}

TEST(RegistryTable, RefusesADuplicate) {
    Registry<int()> table("thing");
    table.add({"one", "", {}, [] { return 1; }});
    EXPECT_THROW(table.add({"one", "", {}, [] { return 2; }}), std::logic_error);
    ASSERT_NE(table.find("one"), nullptr);
    EXPECT_EQ(table.find("one")->make(), 1);
    EXPECT_EQ(table.find("two"), nullptr);
}

TEST_F(FolderTest, WritesAtomicallyAndKeepsTheOldFileOnFailure) {
    const std::string file = path("a.txt");
    write_file(file, "old");
    EXPECT_EQ(read_file(file), "old");
    EXPECT_THROW(write_atomically(file,
                                  [](const std::string& temporary) {
                                      std::ofstream(temporary) << "half";
                                      throw Error::resource("disk full");
                                  }),
                 Error);
    EXPECT_EQ(read_file(file), "old");
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()), 1);
}

TEST_F(FolderTest, SaysWhyAFileCannotBeReadOrWritten) {
    EXPECT_EQ(message_of([&] { read_file(path("none.txt")); }),
              path("none.txt") + ": no such file");
    EXPECT_EQ(message_of([&] { read_file(folder_.path().string()); }),
              folder_.path().string() + ": is a folder, not a file");
    EXPECT_EQ(message_of([&] { write_file(path("no/such/x.txt"), ""); }),
              "cannot write " + path("no/such/x.txt") + ": no such folder " + path("no/such"));
    EXPECT_EQ(message_of([&] { write_file(folder_.path().string(), ""); }),
              "cannot write " + folder_.path().string() + ": is a folder");
}

TEST(FileNames, EndingAndRelativePaths) {
    EXPECT_EQ(extension("/a/b.c/Picture.EXR"), "exr");
    EXPECT_EQ(extension("/a/b.c/picture"), "");
    EXPECT_EQ(file_name("/a/b/toys.lua"), "toys.lua");
    EXPECT_EQ(resolve_path("m/x.obj", "/s/toys.lua"), "/s/m/x.obj");
    EXPECT_EQ(resolve_path("../x.obj", "/s/t/toys.lua"), "/s/x.obj");
    EXPECT_EQ(resolve_path("/x.obj", "/s/toys.lua"), "/x.obj");
}

TEST(ParallelLoop, VisitsEveryIndexOnce) {
    std::vector<int> visits(100000);
    parallel_for(visits.size(), 64, [&](std::size_t i) { ++visits[i]; });
    EXPECT_TRUE(std::all_of(visits.begin(), visits.end(), [](int n) { return n == 1; }));
}

} // namespace
} // namespace scree
