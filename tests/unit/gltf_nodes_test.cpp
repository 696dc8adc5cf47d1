// SPDX-License-Identifier: GPL-3.0-or-later
// Where a glTF file's nodes, skins and instances put its meshes, and what holds its data.
#include "core/error.h"
#include "core/file.h"
#include "formats/read_mesh.h"
#include "tests/support/folder.h"
#include "tests/support/gltf_builder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>

namespace scree {
namespace {

using namespace tests;

FileMesh read(const GltfBuilder& file) { return read_gltf(file.text(), ""); }

std::string problem_of(const std::function<void()>& run) {
    try {
        run();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

std::string problem(const GltfBuilder& file) {
    return problem_of([&] { read(file); });
}

double area_of(const FileMesh& mesh) { return area(to_mesh(mesh)); }

Box3 box_of(const FileMesh& mesh) { return bounds(to_mesh(mesh)); }

/// A square of side 1 below a node with this content.
GltfBuilder square_at(Json node) {
    GltfBuilder file;
    node["mesh"] = file.mesh(file.square());
    file.scene({file.node(node)});
    return file;
}

TEST(GltfNodes, PlaceMeshes) {
    struct Case {
        Json node;
        double area;
        Box3 box;
    };
    const double h = std::sqrt(0.5);
    const std::vector<Case> cases{
        {Json::object(), 1, {{0, 0, 0}, {1, 0, 1}}},
        {{{"translation", {1, 2, 3}}}, 1, {{1, 2, 3}, {2, 2, 4}}},
        {{{"scale", {2, 5, 3}}}, 6, {{0, 0, 0}, {2, 0, 3}}},
        {{{"scale", {-2, 1, 1}}}, 2, {{-2, 0, 0}, {0, 0, 1}}},
        {{{"rotation", {0, 0, h, h}}}, 1, {{0, 0, 0}, {0, 1, 1}}},         // x becomes y
        {{{"rotation", {0, 0, 2 * h, 2 * h}}}, 1, {{0, 0, 0}, {0, 1, 1}}}, // not of length 1
        {{{"rotation", {0, 0, h, h}}, {"scale", {3, 1, 1}}, {"translation", {0, 1, 0}}},
         3,
         {{0, 1, 0}, {0, 4, 1}}},
        {{{"matrix", {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 5, 0, 0, 1}}},
         1,
         {{5, 0, 0}, {5, 1, 1}}},
        // Flat squares stay, whatever shrinks the other direction.
        {{{"scale", {3, 0, 2}}}, 6, {{0, 0, 0}, {3, 0, 2}}},
        {{{"scale", {1e-16, 1e-16, 1e-16}}}, 1e-32, {{0, 0, 0}, {1e-16F, 0, 1e-16F}}},
    };
    for (const Case& c : cases) {
        SCOPED_TRACE(c.node.dump());
        const FileMesh mesh = read(square_at(c.node));
        EXPECT_NEAR(area_of(mesh), c.area, 1e-6 * c.area);
        const Box3 box = box_of(mesh);
        const float allowed = 1e-6F * float(std::sqrt(c.area));
        EXPECT_TRUE(box.min.equalWithAbsError(c.box.min, allowed)) << box.min;
        EXPECT_TRUE(box.max.equalWithAbsError(c.box.max, allowed)) << box.max;
    }
}

TEST(GltfNodes, MirrorsKeepTheOutside) {
    for (const Json& scale : std::vector<Json>{{1, 1, 1}, {-1, 1, 1}, {-1, -2, -1}, {2, -1, 1}}) {
        GltfBuilder file;
        file.scene({file.node({{"mesh", file.mesh(file.corner())}, {"scale", scale}})});
        const double factor =
            std::abs(scale[0].get<double>() * scale[1].get<double>() * scale[2].get<double>());
        EXPECT_NEAR(volume(to_mesh(read(file))), factor / 6, 1e-7) << scale.dump();
    }
}

TEST(GltfNodes, ScaleOfZeroShowsNothing) {
    const double h = std::sqrt(0.5);
    const std::vector<Json> hidden{
        {{"scale", {0, 0, 0}}},
        {{"scale", {0, 0, 1}}},
        {{"scale", {0, 1, 0}}, {"rotation", {h, 0, 0, h}}},
        {{"scale", {0, 0, 3}}, {"rotation", {0.1, 0.7, 0.3, 0.5}}, {"translation", {1, 1, 1}}},
        {{"matrix", {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 3, 4, 5, 1}}}};
    for (const Json& node : hidden) {
        GltfBuilder file = square_at(node);
        EXPECT_EQ(problem(file), "all it shows is shrunk to nothing by a scale of 0")
            << node.dump();
        file.json["scenes"][0]["nodes"].push_back(file.node({{"mesh", 0}}));
        EXPECT_NEAR(area_of(read(file)), 1, 1e-7) << node.dump();
    }
    // What is below a node of scale 0 is as small.
    GltfBuilder file = square_at({{"translation", {4, 0, 0}}});
    file.json["scenes"][0]["nodes"] = {file.node({{"children", {0}}, {"scale", {0, 0, 0}}})};
    EXPECT_EQ(problem(file), "all it shows is shrunk to nothing by a scale of 0");
}

TEST(GltfNodes, FlattenedSolidsAreFlat) {
    GltfBuilder file;
    Json corner = file.corner();
    corner["attributes"]["NORMAL"] = file.points({{-1, -1, -1}, {1, 0, 0}, {0, 1, 0}, {0, -1, 1}});
    file.scene({file.node(
        {{"mesh", file.mesh(corner)}, {"scale", {1, 0, 1}}, {"translation", {0, 7, 0}}})});
    const FileMesh mesh = read(file);
    // Seen from above and from below: two faces of area 1/2 each, the others have none.
    EXPECT_NEAR(area_of(mesh), 1, 1e-7);
    for (const Imath::V3d& p : mesh.positions)
        EXPECT_EQ(p.y, 7);
    ASSERT_EQ(mesh.normals.size(), 4U);
    EXPECT_EQ(mesh.normals[0], Vec3(0, -1, 0));
    EXPECT_EQ(mesh.normals[2], Vec3(0, 1, 0));
    for (const Vec3& normal : mesh.normals)
        EXPECT_EQ(std::abs(normal.y), 1) << normal;
}

TEST(GltfNodes, DoublePrecision) {
    GltfBuilder file = square_at({{"translation", {0.25, 0, 0}}});
    file.json["scenes"][0]["nodes"] = {
        file.node({{"children", {0}}, {"translation", {5e6, 100.125, -4e6}}})};
    const FileMesh mesh = read(file);
    EXPECT_EQ(mesh.positions[0], Imath::V3d(5000000.25, 100.125, -4e6));
}

TEST(GltfNodes, ChainsOfAnyLength) {
    for (const int length : {1, 64, 100, 10000}) {
        GltfBuilder file = square_at(Json::object());
        for (int i = 1; i <= length; ++i)
            file.node({{"children", {i - 1}}, {"translation", {1, 0, 0}}});
        file.json["scenes"][0]["nodes"] = {length};
        EXPECT_EQ(box_of(read(file)).min.x, float(length));
    }
}

TEST(GltfNodes, TreesOnly) {
    GltfBuilder ring = square_at({{"children", {1}}});
    ring.node({{"children", {2}}});
    ring.node({{"children", {0}}});
    EXPECT_EQ(problem(ring), "nodes[0] is in a ring of children");
    GltfBuilder itself = square_at({{"children", {0}}});
    EXPECT_EQ(problem(itself), "nodes[0] is in a ring of children");
    GltfBuilder shared = square_at(Json::object());
    shared.node({{"children", {0}}});
    shared.node({{"children", {0}}});
    EXPECT_EQ(problem(shared),
              "nodes[0] is a child of nodes[1] and of nodes[2]; a node has one parent");
}

TEST(GltfNodes, TheSceneIsShown) {
    // A square in scene 0, two in scene 1, one in none.
    GltfBuilder file;
    file.mesh(file.square());
    for (int i = 0; i < 4; ++i)
        file.node({{"mesh", 0}, {"translation", {2 * i, 0, 0}}});
    file.scene({0});
    file.scene({1, 2});
    const auto unseen = [](int count) {
        return std::vector<std::string>{std::to_string(count) +
                                        " of its nodes with meshes are hidden, or not in the scene "
                                        "that it shows, and are not read"};
    };
    EXPECT_NEAR(area_of(read(file)), 1, 1e-7);
    EXPECT_EQ(read(file).warnings, unseen(3));
    file.json["scene"] = 1;
    EXPECT_NEAR(area_of(read(file)), 2, 1e-7);
    EXPECT_EQ(read(file).warnings, unseen(2));
    file.json.erase("scene"); // the first
    EXPECT_EQ(read(file).warnings, unseen(3));
    file.json.erase("scenes"); // all
    EXPECT_NEAR(area_of(read(file)), 4, 1e-7);
    EXPECT_TRUE(read(file).warnings.empty());
    file.json.erase("nodes"); // the mesh alone
    EXPECT_NEAR(area_of(read(file)), 1, 1e-7);
    file.node({{"translation", {1, 0, 0}}});
    file.scene({0});
    EXPECT_EQ(read_gltf(file.text(), "").triangles.size(), 0U); // see MeshFile: an error there
}

TEST(GltfNodes, HiddenNodes) {
    GltfBuilder file = square_at(Json::object());
    const int hidden = file.node(
        {{"children", {0}}, {"extensions", {{"KHR_node_visibility", {{"visible", false}}}}}});
    file.json["scenes"][0]["nodes"] = {hidden};
    EXPECT_EQ(problem(file), "its scene shows no mesh");
    file.json["nodes"][1]["extensions"]["KHR_node_visibility"]["visible"] = true;
    EXPECT_NEAR(area_of(read(file)), 1, 1e-7);
}

TEST(GltfNodes, InstancesAreMerged) {
    GltfBuilder file;
    const double h = std::sqrt(0.5);
    const auto turn = static_cast<std::int16_t>(std::lround(h * 32767));
    const Json attributes = {
        {"TRANSLATION", file.floats(3, {0, 0, 0, 10, 0, 0, 0, 0, 20})},
        {"ROTATION", file.numbers<std::int16_t>(
                         5122, 4, {0, 0, 0, 32767, 0, 0, turn, turn, 0, 0, 0, 32767}, true)},
        {"SCALE", file.floats(3, {1, 1, 1, 2, 2, 2, 0, 0, 0})}};
    file.scene(
        {file.node({{"mesh", file.mesh(file.square())},
                    {"translation", {0, 1, 0}},
                    {"extensions", {{"EXT_mesh_gpu_instancing", {{"attributes", attributes}}}}}})});
    const FileMesh mesh = read(file);
    EXPECT_EQ(mesh.triangles.size(), 4U); // the third is shrunk to nothing
    EXPECT_NEAR(area_of(mesh), 1 + 4, 1e-3);
    EXPECT_TRUE(box_of(mesh).min.equalWithAbsError(Vec3(0, 1, 0), 1e-3F));
    EXPECT_TRUE(box_of(mesh).max.equalWithAbsError(Vec3(10, 3, 2), 1e-3F));
    file.json["accessors"][2]["count"] = 2;
    EXPECT_EQ(problem(file), "nodes[0]: its instances differ in number: 3 and 2");
}

/// A square whose corners at z = 1 follow a joint that turns about x at z = 0.5.
struct Skinned {
    GltfBuilder file;

    explicit Skinned(const std::vector<float>& weights) {
        Json square = file.square();
        square["attributes"]["JOINTS_0"] =
            file.numbers<std::uint8_t>(5121, 4, {0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0});
        square["attributes"]["WEIGHTS_0"] = file.floats(4, weights);
        const double h = std::sqrt(0.5);
        const int mesh = file.mesh(square);
        // The node's own place does not count.
        file.node({{"mesh", mesh}, {"skin", 0}, {"translation", {100, 100, 100}}});
        file.node({{"children", {2}}});
        file.node({{"translation", {0, 0, 0.5}}, {"rotation", {-h, 0, 0, h}}});
        const int inverse =
            file.numbers<float>(5126, 16, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0,     1,
                                           1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -0.5F, 1});
        file.json["skins"] = {{{"joints", {1, 2}}, {"inverseBindMatrices", inverse}}};
        file.scene({0, 1});
    }
};

TEST(GltfNodes, SkinsAreInTheFilesPose) {
    // Turned by -90 degrees about x, z goes to y: (x, 0, 1) becomes (x, 0.5, 0.5).
    Skinned bent({1, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0});
    const FileMesh mesh = read(bent.file);
    const Imath::V3d expected[] = {{0, 0, 0}, {0, 0.5, 0.5}, {1, 0, 0}, {1, 0.5, 0.5}};
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_TRUE(mesh.positions[i].equalWithAbsError(expected[i], 1e-6)) << mesh.positions[i];
    // Half of each joint: the mean of (x, 0, 1) and (x, 0.5, 0.5). Weights are shares of their sum.
    Skinned mixed({1, 0, 0, 0, 2, 2, 0, 0, 1, 0, 0, 0, 0.5, 0.5, 0, 0});
    const FileMesh half = read(mixed.file);
    EXPECT_TRUE(half.positions[1].equalWithAbsError({0, 0.25, 0.75}, 1e-6));
    EXPECT_TRUE(half.positions[3].equalWithAbsError({1, 0.25, 0.75}, 1e-6));
}

TEST(GltfNodes, SkinsWithoutInverseMatrices) {
    Skinned skinned({1, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0});
    skinned.file.json["skins"][0].erase("inverseBindMatrices");
    // (x, 0, 1) turned becomes (x, 1, 0), then moved by 0.5 along z.
    EXPECT_TRUE(read(skinned.file).positions[1].equalWithAbsError(Imath::V3d(0, 1, 0.5), 1e-6));
}

TEST(GltfNodes, DamagedSkins) {
    const std::vector<float> weights{1, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0};
    Skinned none({1, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0});
    EXPECT_EQ(problem(none.file), "meshes[0].primitives[0]: vertex 1 has no joint of skins[0]");
    Skinned few(weights);
    few.file.json["skins"][0]["joints"] = {1};
    EXPECT_EQ(problem(few.file),
              "meshes[0].primitives[0]: vertex 1 names joint 1 of 1 in skins[0]");
    Skinned matrices(weights);
    matrices.file.json["skins"][0]["joints"] = {1, 2, 1};
    EXPECT_EQ(problem(matrices.file), "skins[0] has 3 joints, but 2 inverse bind matrices");
    Skinned short_weights(weights);
    short_weights.file.json["accessors"][3]["count"] = 3;
    EXPECT_EQ(problem(short_weights.file), "meshes[0].primitives[0]: its JOINTS_0 and WEIGHTS_0 do "
                                           "not match its 4 positions");
}

class GltfFiles : public testing::Test {
  protected:
    void SetUp() override { std::filesystem::create_directories(folder + "/sub folder"); }

    test::Folder temporary;
    std::string folder = temporary.path().string();
};

TEST_F(GltfFiles, UrisOfBuffers) {
    struct Case {
        const char* file;
        const char* uri;
    };
    const std::vector<Case> cases{
        {"plain.bin", "plain.bin"},
        {"plain.bin", "./plain.bin"},
        {"two words.bin", "two words.bin"},
        {"two words.bin", "two%20words.bin"},
        {"100% wool.bin", "100%25%20wool.bin"},
        {"10%.bin", "10%.bin"},
        {"10%2.bin", "10%2.bin"},
        {"50%ab.bin", "50%ab.bin"}, // looks encoded, and is not
        {"a+b.bin", "a+b.bin"},
        {"a+b.bin", "a%2Bb.bin"},
        {"a#b.bin", "a%23b.bin"},
        {"a#b.bin", "a#b.bin"},
        {"what?.bin", "what%3f.bin"},
        {"名前.bin", "名前.bin"},
        {"名前.bin", "%E5%90%8D%E5%89%8D.bin"},
        {"sub folder/b.bin", "sub%20folder/b.bin"},
        {"sub folder/b.bin", "sub folder\\b.bin"},
    };
    for (const Case& c : cases) {
        GltfBuilder file = square_at(Json::object());
        file.json["buffers"] = {{{"byteLength", file.data.size()}, {"uri", c.uri}}};
        write_file(folder + "/" + c.file, file.data);
        EXPECT_NEAR(area_of(read_gltf(file.text(), folder)), 1, 1e-7) << c.uri;
        std::filesystem::remove(folder + "/" + c.file);
        EXPECT_EQ(problem_of([&] { read_gltf(file.text(), folder); }),
                  std::string("buffers[0]: there is no file ") + c.uri + " beside it");
    }
}

TEST_F(GltfFiles, OtherUris) {
    GltfBuilder file = square_at(Json::object());
    struct Case {
        std::string uri;
        std::string error;
    };
    for (const Case& c : {
             Case{"data:;base64," + base64(file.data), "no error"},
             Case{"data:application/gltf-buffer;base64," + base64(file.data), "no error"},
             Case{"data:text/plain,abc",
                  "buffers[0] should be 60 bytes long, but there are only 3"},
             Case{"data:;base64", "buffers[0]: a data: URI has no comma"},
             Case{"data:;base64,A*AA", "buffers[0]: the base64 of a data: URI is damaged"},
             Case{"https://example.org/a.bin",
                  "buffers[0]: https://example.org/a.bin is not a file beside it"},
             Case{"sub folder", "buffers[0]: there is no file sub folder beside it"},
             Case{"/dev/zero", "buffers[0]: there is no file /dev/zero beside it"},
         }) {
        file.json["buffers"] = {{{"byteLength", 60}, {"uri", c.uri}}};
        EXPECT_EQ(problem_of([&] { read_gltf(file.text(), folder); }), c.error);
    }
    file.json["buffers"] = {{{"byteLength", 60}}};
    EXPECT_EQ(problem(file), "buffers[0] has no data");
}

TEST_F(GltfFiles, BinaryContainers) {
    const std::string good = square_at(Json::object()).binary();
    EXPECT_NEAR(area_of(read_gltf(good, "")), 1, 1e-7);
    const auto with = [&](std::size_t offset, std::uint32_t value) {
        std::string bytes = good;
        std::memcpy(bytes.data() + offset, &value, sizeof value);
        return problem_of([&] { read_gltf(bytes, ""); });
    };
    const auto size = static_cast<std::uint32_t>(good.size());
    std::uint32_t json = 0;
    std::memcpy(&json, good.data() + 12, sizeof json);
    EXPECT_EQ(with(4, 1), "it is of glTF version 1; only version 2 is read");
    EXPECT_EQ(with(8, size + 1), "it ends too early: its header promises " +
                                     std::to_string(size + 1) + " bytes, there are " +
                                     std::to_string(size));
    EXPECT_EQ(with(12, size), "its chunk 0 should be " + std::to_string(size) +
                                  " bytes long, but there are only " + std::to_string(size - 20));
    EXPECT_EQ(with(16, 0), "its first chunk is not JSON");
    EXPECT_EQ(with(20 + json, 64), "its chunk 1 should be 64 bytes long, but there are only 60");
    EXPECT_EQ(with(20 + json, 56), "buffers[0] should be 60 bytes long, but there are only 56");
    EXPECT_EQ(with(24 + json, 7), "buffers[0] has no data"); // an unknown chunk
    EXPECT_EQ(problem_of([&] { read_gltf(good.substr(0, 18), ""); }), "it ends too early");
    const FileMesh longer = read_gltf(good + "xyz", "");
    EXPECT_EQ(longer.warnings,
              std::vector<std::string>{
                  "the 3 bytes beyond the length that its header names are not read"});
}

TEST_F(GltfFiles, DamagedJson) {
    for (const std::string& text :
         {std::string("{"), std::string("not json"), std::string(1'000'000, '['), std::string()})
        EXPECT_EQ(problem_of([&] {
                      read_gltf(text, "");
                  }).rfind("its JSON is damaged: parse error at line 1, column ", 0),
                  0U);
    const std::string deep = std::string(1'000'000, '[') + std::string(1'000'000, ']');
    EXPECT_EQ(problem_of([&] { read_gltf(deep, ""); }), "it must be an object, not a list of 1");
    EXPECT_EQ(problem_of([&] { read_gltf("{}", ""); }), "it has no asset");
}

} // namespace
} // namespace scree
