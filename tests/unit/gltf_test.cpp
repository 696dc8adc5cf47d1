// SPDX-License-Identifier: GPL-3.0-or-later
// What of a glTF file becomes triangles, and what is said of the rest.
#include "core/error.h"
#include "formats/read_mesh.h"
#include "tests/support/gltf_builder.h"

#include <gtest/gtest.h>

#include <functional>

namespace scree {
namespace {

using namespace tests;

/// The vector whose length is the area of a flat mesh, on the side that it faces.
Imath::V3d facing(const FileMesh& mesh) {
    Imath::V3d twice(0.0);
    for (const Mesh::Triangle& t : mesh.triangles) {
        const Imath::V3d& a = mesh.positions[t[0]];
        twice += (mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a);
    }
    return twice / 2;
}

double volume_of(const FileMesh& mesh) { return volume(to_mesh(mesh)); }

std::string problem(const GltfBuilder& file) {
    try {
        read_gltf(file.text(), "");
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

/// The file with one node that bears `primitive`.
FileMesh read_one(GltfBuilder& file, const Json& primitive, Json node = Json::object()) {
    node["mesh"] = file.mesh(primitive);
    file.scene({file.node(node)});
    return read_gltf(file.text(), "");
}

TEST(Gltf, PrimitiveModes) {
    // Points in the plane y = 0; triangles that face up have a positive area.
    const std::vector<Vec3> row{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 0, 1}, {2, 0, 0}, {2, 0, 1}};
    const std::vector<Vec3> hexagon{{0, 0, 0}, {1, 0, 0}, {0, 0, -1}, {-1, 0, 0}, {0, 0, 1}};
    struct Case {
        int mode;
        std::vector<Vec3> points;
        std::vector<std::uint16_t> indices; // none: in order
        std::size_t triangles;
        double area;
        std::string warning;
    };
    const std::vector<Case> cases{
        {4, row, {0, 1, 2, 2, 1, 3}, 2, 1, ""},
        {4, row, {}, 2, 0, ""}, // 0 1 2 faces up, 3 4 5 down
        {4,
         row,
         {0, 1, 2, 3, 4},
         1,
         0.5,
         "2 of its vertex numbers, at the ends of primitives, make no triangle and are not read"},
        {5, row, {}, 4, 2, ""},
        {5, row, {0, 1, 2, 3}, 2, 1, ""},
        {5, row, {1, 0, 3, 2}, 2, -1, ""},
        {5, row, {0, 1, 2, 3, 3, 2, 2, 3, 4, 5}, 4, 2, ""}, // two strips, joined
        {6, hexagon, {}, 3, 1.5, ""},
        {6, hexagon, {0, 1, 2, 3, 4, 1}, 4, 2, ""},
        {6, hexagon, {0, 1, 2, 2, 3}, 2, 1, ""},
    };
    for (const Case& c : cases) {
        GltfBuilder file;
        Json primitive = {{"attributes", {{"POSITION", file.points(c.points)}}}, {"mode", c.mode}};
        if (!c.indices.empty())
            primitive["indices"] = file.indices(c.indices);
        SCOPED_TRACE(primitive.dump());
        const FileMesh mesh = read_one(file, primitive);
        EXPECT_EQ(mesh.triangles.size(), c.triangles);
        EXPECT_NEAR(facing(mesh).y, c.area, 1e-12);
        EXPECT_EQ(mesh.warnings, c.warning.empty() ? std::vector<std::string>{}
                                                   : std::vector<std::string>{c.warning});
    }
}

TEST(Gltf, PointsAndLinesAreNamed) {
    for (int mode = 0; mode < 4; ++mode) {
        GltfBuilder file;
        Json primitive = file.square();
        primitive["mode"] = mode;
        file.scene({file.node({{"mesh", file.mesh(primitive)}})});
        EXPECT_EQ(problem(file), "it has only points and lines; a mesh needs triangles");
        file.json["meshes"][0]["primitives"].push_back(file.square());
        const FileMesh mesh = read_gltf(file.text(), "");
        EXPECT_EQ(mesh.triangles.size(), 2U);
        EXPECT_EQ(mesh.warnings,
                  std::vector<std::string>{
                      "1 of its primitives are points or lines, which are not read"});
    }
    GltfBuilder file;
    file.scene({file.node({{"mesh", file.mesh({{"attributes", Json::object()}, {"mode", 7}})}})});
    EXPECT_EQ(problem(file), "meshes[0].primitives[0] has the unknown mode 7");
}

TEST(Gltf, IndicesInRangeOnly) {
    GltfBuilder file;
    Json primitive = file.square();
    primitive["indices"] = file.indices({0, 1, 65535});
    file.scene({file.node({{"mesh", file.mesh(primitive)}})});
    EXPECT_EQ(problem(file), "meshes[0].primitives[0]: a face names vertex 65535 of 4");
    for (const int code : {5121, 5125}) {
        GltfBuilder other;
        Json square = other.square();
        square["indices"] = code == 5121
                                ? other.numbers<std::uint8_t>(5121, 1, {0, 1, 2, 2, 1, 3})
                                : other.numbers<std::uint32_t>(5125, 1, {0, 1, 2, 2, 1, 3});
        EXPECT_NEAR(facing(read_one(other, square)).y, 1, 1e-12);
    }
    GltfBuilder fractions;
    Json square = fractions.square();
    square["indices"] = fractions.floats(1, {0, 1, 2});
    fractions.scene({fractions.node({{"mesh", fractions.mesh(square)}})});
    EXPECT_EQ(problem(fractions), "accessors[2] must hold whole numbers");
}

TEST(Gltf, IntegerTextureCoordinates) {
    const std::vector<Vec2f> expected{{0, 1}, {1, 1}, {0, 0}, {1, 0.6F}}; // v from below
    struct Case {
        const char* name;
        std::function<int(GltfBuilder&)> add;
    };
    const std::vector<Case> cases{
        {"float",
         [](GltfBuilder& f) {
             return f.floats(2, {0, 0, 1, 0, 0, 1, 1, 0.4F});
         }},
        {"8 bits",
         [](GltfBuilder& f) {
             return f.numbers<std::uint8_t>(5121, 2, {0, 0, 255, 0, 0, 255, 255, 102}, true);
         }},
        {"16 bits",
         [](GltfBuilder& f) {
             return f.numbers<std::uint16_t>(5123, 2, {0, 0, 65535, 0, 0, 65535, 65535, 26214},
                                             true);
         }},
        {"signed",
         [](GltfBuilder& f) {
             return f.numbers<std::int8_t>(5120, 2, {0, 0, 127, 0, 0, 127, 127, 51}, true);
         }},
    };
    for (const Case& c : cases) {
        GltfBuilder file;
        Json square = file.square();
        square["attributes"]["TEXCOORD_0"] = c.add(file);
        const FileMesh mesh = read_one(file, square);
        ASSERT_EQ(mesh.uvs.size(), 4U) << c.name;
        for (std::size_t i = 0; i < 4; ++i)
            EXPECT_TRUE(mesh.uvs[i].equalWithAbsError(expected[i], 0.002F)) << c.name << " " << i;
    }
}

TEST(Gltf, QuantisedPositions) {
    for (const bool normalized : {false, true}) {
        GltfBuilder file;
        file.json["extensionsRequired"] = {"KHR_mesh_quantization"};
        Json square = file.square();
        const std::int16_t side = normalized ? 32767 : 100;
        // Three numbers and a gap: elements begin at multiples of four bytes.
        const int positions = file.numbers<std::int16_t>(
            5122, 4, {0, 0, 0, 9, 0, 0, side, 9, side, 0, 0, 9, side, 0, side, 9}, normalized);
        file.json["accessors"][std::size_t(positions)]["type"] = "VEC3";
        file.json["bufferViews"].back()["byteStride"] = 8;
        square["attributes"]["POSITION"] = positions;
        const FileMesh mesh = read_one(file, square);
        EXPECT_NEAR(facing(mesh).y, normalized ? 1 : 10000, 1e-9);
    }
}

TEST(Gltf, SparseAccessors) {
    for (const bool with_view : {true, false}) {
        GltfBuilder file;
        Json square = file.square();
        Json& accessor =
            file.json["accessors"][square["attributes"]["POSITION"].get<std::size_t>()];
        if (!with_view)
            accessor.erase("bufferView"); // zeros
        const int at = file.view(std::string("\1\0\2\0\3\0", 6));
        std::string bytes;
        for (const float x : {0.F, 0.F, 3.F, 2.F, 0.F, 0.F, 2.F, 0.F, 3.F})
            put(bytes, x);
        const int values = file.view(bytes);
        accessor["sparse"] = {{"count", 3},
                              {"indices", {{"bufferView", at}, {"componentType", 5123}}},
                              {"values", {{"bufferView", values}}}};
        EXPECT_NEAR(facing(read_one(file, square)).y, 6, 1e-12) << with_view;
        accessor["count"] = 3;
        EXPECT_EQ(problem(file), "accessors[0].sparse.indices names element 3 of 3");
        accessor["count"] = 4;
        accessor["sparse"]["count"] = 4;
        EXPECT_EQ(problem(file),
                  "accessors[0].sparse.indices reaches beyond bufferViews[2], which has 6 bytes");
    }
}

TEST(Gltf, DefaultMorphWeights) {
    struct Case {
        Json mesh_weights;
        Json node_weights;
        double height; // of the square
        std::string error;
    };
    const std::vector<Case> cases{
        {nullptr, nullptr, 0, ""},
        {{0.5, 0}, nullptr, 1, ""},
        {{0.5, 0.25}, nullptr, 2, ""},
        {{0.5, 0.25}, {0, 1}, 4, ""},
        {{1}, nullptr, 0, "meshes[0].primitives[0] has 2 morph targets, but 1 weight"},
        {{1, 2, 3}, nullptr, 0, "meshes[0].primitives[0] has 2 morph targets, but 3 weights"},
    };
    for (const Case& c : cases) {
        GltfBuilder file;
        Json square = file.square();
        const int up_2 = file.points({{0, 2, 0}, {0, 2, 0}, {0, 2, 0}, {0, 2, 0}});
        const int up_4 = file.accessor({{"componentType", 5126}, {"count", 4}, {"type", "VEC3"}});
        std::string heights;
        for (int i = 0; i < 4; ++i)
            for (const float x : {0.F, 4.F, 0.F})
                put(heights, x);
        const int at = file.view(std::string("\0\1\2\3", 4));
        const int values = file.view(heights);
        file.json["accessors"][std::size_t(up_4)]["sparse"] = {
            {"count", 4},
            {"indices", {{"bufferView", at}, {"componentType", 5121}}},
            {"values", {{"bufferView", values}}}};
        square["targets"] = {{{"POSITION", up_2}}, {{"POSITION", up_4}}};
        const int mesh = file.mesh(square);
        Json node = {{"mesh", mesh}};
        if (!c.mesh_weights.is_null())
            file.json["meshes"][0]["weights"] = c.mesh_weights;
        if (!c.node_weights.is_null())
            node["weights"] = c.node_weights;
        file.scene({file.node(node)});
        if (!c.error.empty()) {
            EXPECT_EQ(problem(file), c.error);
            continue;
        }
        const FileMesh read = read_gltf(file.text(), "");
        for (const Imath::V3d& p : read.positions)
            EXPECT_NEAR(p.y, c.height, 1e-12);
    }
}

TEST(Gltf, MorphedNormalsAndUvs) {
    GltfBuilder file;
    Json square = file.square();
    square["attributes"]["NORMAL"] = file.points({4, Vec3(0, 1, 0)});
    square["attributes"]["TEXCOORD_0"] = file.floats(2, {0, 0, 0, 0, 0, 0, 0, 0});
    square["targets"] = {{{"NORMAL", file.points({4, Vec3(1, 0, 0)})},
                          {"TEXCOORD_0", file.floats(2, {.5F, 0, .5F, 0, .5F, 0, .5F, 0})}}};
    file.scene({file.node({{"mesh", file.mesh(square)}, {"weights", {1}}})});
    const FileMesh mesh = read_gltf(file.text(), "");
    const float half = std::sqrt(0.5F);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_TRUE(mesh.normals[i].equalWithAbsError(Vec3(half, half, 0), 1e-6F));
        EXPECT_EQ(mesh.uvs[i], Vec2f(0.5F, 1.0F));
    }
}

TEST(Gltf, NormalsOfAllOrNone) {
    // The tetrahedron has normals and the square has none: it gets its own.
    GltfBuilder file;
    Json corner = file.corner();
    corner["attributes"]["NORMAL"] = file.points({4, Vec3(0, 0, 2)});
    file.mesh(corner);
    file.json["meshes"][0]["primitives"].push_back(file.square());
    file.scene({file.node({{"mesh", 0}})});
    const FileMesh mesh = read_gltf(file.text(), "");
    ASSERT_EQ(mesh.positions.size(), 4U + 6U);
    ASSERT_EQ(mesh.normals.size(), mesh.positions.size());
    EXPECT_EQ(mesh.normals[0], Vec3(0, 0, 1));
    for (std::size_t i = 4; i < 10; ++i)
        EXPECT_EQ(mesh.normals[i], Vec3(0, 1, 0));
    EXPECT_NEAR(volume_of(mesh), 1.0 / 6, 1e-7);
}

TEST(Gltf, RequiredExtensions) {
    for (const char* name : {"KHR_draco_mesh_compression", "EXT_meshopt_compression",
                             "KHR_meshopt_compression", "VENDOR_curved_space"}) {
        GltfBuilder file;
        file.scene({file.node({{"mesh", file.mesh(file.square())}})});
        file.json["extensionsRequired"] = {"KHR_materials_unlit", name};
        EXPECT_EQ(problem(file), "it requires the extension " + std::string(name) +
                                     ", which is not read; export it without");
    }
    for (const char* name :
         {"KHR_mesh_quantization", "EXT_mesh_gpu_instancing", "KHR_texture_transform",
          "KHR_materials_transmission", "KHR_node_visibility", "KHR_texture_basisu",
          "EXT_texture_webp", "KHR_lights_punctual"}) {
        GltfBuilder file;
        file.json["extensionsRequired"] = {name};
        EXPECT_NEAR(facing(read_one(file, file.square())).y, 1, 1e-12) << name;
    }
}

TEST(Gltf, CompressedDataNeedAnotherCopy) {
    GltfBuilder draco;
    Json square = draco.square();
    square["extensions"]["KHR_draco_mesh_compression"] = {{"bufferView", 0},
                                                          {"attributes", {{"POSITION", 0}}}};
    draco.scene({draco.node({{"mesh", draco.mesh(square)}})});
    EXPECT_EQ(problem(draco), "no error");        // the accessors have all data
    for (const std::size_t accessor : {0U, 1U}) { // the positions, the indices
        GltfBuilder half = draco;
        half.json["accessors"][accessor].erase("bufferView");
        EXPECT_EQ(problem(half).rfind("meshes[0].primitives[0] is compressed by ", 0), 0U);
    }
    draco.json["accessors"][0].erase("bufferView");
    EXPECT_EQ(problem(draco), "meshes[0].primitives[0] is compressed by "
                              "KHR_draco_mesh_compression, which is not read; export it without");

    GltfBuilder meshopt;
    meshopt.scene({meshopt.node({{"mesh", meshopt.mesh(meshopt.square())}})});
    Json& view = meshopt.json["bufferViews"][0];
    view["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0}, {"byteLength", 8}};
    EXPECT_EQ(problem(meshopt), "no error");
    meshopt.json["buffers"] = {
        {{"byteLength", meshopt.data.size()},
         {"uri", "data:application/octet-stream;base64," + base64(meshopt.data)}},
        {{"byteLength", 48}}};
    view["buffer"] = 1;
    EXPECT_EQ(problem(meshopt), "bufferViews[0] is compressed by EXT_meshopt_compression, which is "
                                "not read; export it without");
}

TEST(Gltf, OtherVersions) {
    for (const auto& [version, text] :
         {std::pair("1.0", "it is of glTF version 1.0; only version 2 is read"),
          std::pair("3.0", "it is of glTF version 3.0; only version 2 is read")}) {
        GltfBuilder file;
        file.json["asset"]["version"] = version;
        EXPECT_EQ(problem(file), text);
    }
    GltfBuilder file;
    file.json["asset"]["minVersion"] = "2.1";
    EXPECT_EQ(problem(file), "it needs a reader of glTF 2.1; only version 2.0 is known");
}

TEST(Gltf, WrongTypesAreNamed) {
    struct Case {
        const char* pointer;
        Json value;
        std::string error;
    };
    const std::vector<Case> cases{
        {"/nodes/0/mesh", 7, "nodes[0].mesh is 7, but the file has only meshes[0]"},
        {"/nodes/0/mesh", -1,
         "nodes[0].mesh must be a whole number from 0 to 9007199254740991, not -1"},
        {"/nodes/0/mesh", "a", "nodes[0].mesh must be a number, not a text"},
        {"/meshes/0/primitives/0/indices", 2,
         "meshes[0].primitives[0].indices is 2, but the file has only accessors[0] to "
         "accessors[1]"},
        {"/nodes/0/skin", 0, "nodes[0].skin is 0, but the file has no skins"},
        {"/nodes/0/scale", {1, 2}, "nodes[0].scale must be 3 numbers, not 2"},
        {"/nodes/0/rotation", {0, 0, 0, 0}, "nodes[0] has a rotation of four zeros, which is none"},
        {"/nodes/0/matrix",
         {1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1},
         "nodes[0].matrix must have 0, 0, 0, 1 in its last row"},
        {"/accessors/0/componentType", 5130, "accessors[0] has the unknown componentType 5130"},
        {"/accessors/0/type", "VEC5", "accessors[0] has the unknown type VEC5"},
        {"/accessors/0/type", "VEC2",
         "accessors[0] has 2 numbers in an element where 3 are needed"},
        {"/accessors/0/count", 5, "accessors[0] reaches beyond bufferViews[0], which has 48 bytes"},
        {"/accessors/0/bufferView", nullptr, "accessors[0].bufferView must be a number, not null"},
        {"/bufferViews/0/byteLength", 4000, "bufferViews[0] reaches beyond its buffer of 60 bytes"},
        {"/meshes/0/primitives", 1, "meshes[0].primitives must be a list, not 1"},
        {"/asset", Json::object(), "asset has no version"},
        {"/scene", 1, "scene is 1, but the file has only scenes[0]"},
    };
    for (const Case& c : cases) {
        GltfBuilder file;
        file.scene({file.node({{"mesh", file.mesh(file.square())}})});
        file.json[Json::json_pointer(c.pointer)] = c.value;
        EXPECT_EQ(problem(file), c.error) << c.pointer;
    }
}

} // namespace
} // namespace scree
