// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/read_mesh.h"
#include "formats/table.h"

#include "core/error.h"
#include "core/file.h"
#include "tests/support/folder.h"
#include "tests/support/mesh_bytes.h"
#include "tests/support/mesh_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <filesystem>
#include <functional>
#include <limits>

namespace scree {
namespace {

namespace fs = std::filesystem;
using namespace tests;

class MeshFile : public testing::Test {
  protected:
    std::string write(const std::string& name, std::string_view bytes) {
        std::string path = folder_.file(name);
        write_file(path, bytes);
        return path;
    }

    // The error message for the file, without the folder's name.
    std::string problem(const std::string& name, std::string_view bytes) {
        return without_folder([&] { read_mesh(write(name, bytes)); });
    }

    std::string without_folder(const std::function<void()>& run) {
        try {
            run();
        } catch (const Error& error) {
            std::string text = error.what();
            const std::string prefix = folder_.path().string() + "/";
            for (std::size_t at = 0; (at = text.find(prefix, at)) != std::string::npos;)
                text.erase(at, prefix.size());
            return text;
        }
        return "no error";
    }

    test::Folder folder_;
};

void expect_tetrahedron(const Mesh& mesh) {
    EXPECT_EQ(mesh.triangles.size(), 4U);
    EXPECT_NEAR(volume(mesh), 1.0 / 6, 1e-7);
    EXPECT_TRUE(inspect(mesh).closed());
    EXPECT_EQ(bounds(mesh).min, Vec3(0.0F));
    EXPECT_EQ(bounds(mesh).max, Vec3(1.0F));
}

std::string obj() {
    return "# a comment\no corner\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
           "f 1 3 2\nf 1 2 4\nf -4 -1 -2\nf 2 3 4\n";
}

std::string ply_ascii() {
    return "ply\nformat ascii 1.0\ncomment by hand\nelement vertex 4\nproperty float x\n"
           "property float y\nproperty double z\nproperty uchar red\nelement face 4\n"
           "property list uchar int vertex_indices\nend_header\n"
           "0 0 0 1\n1 0 0 2\n0 1 0 3\n0 0 1 4\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
}

std::string ply_binary(bool big) {
    std::string out = std::string("ply\r\nformat binary_") + (big ? "big" : "little") +
                      "_endian 1.0\r\nelement vertex 4\r\nproperty float x\r\n"
                      "property float y\r\nproperty double z\r\nelement face 4\r\n"
                      "property list uint8 int32 vertex_index\r\nend_header\r\n";
    for (const auto& p : corner_points) {
        put(out, p[0], big);
        put(out, p[1], big);
        put(out, double(p[2]), big);
    }
    for (const auto& f : corner_faces) {
        put(out, std::uint8_t{3});
        for (const int i : f)
            put(out, std::int32_t{i}, big);
    }
    return out;
}

std::string gltf_json(const std::string& uri, const std::string& node) {
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
"nodes":[)" +
           node + R"(],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],
"buffers":[{)" +
           uri + R"("byteLength":72}],
"bufferViews":[{"buffer":0,"byteOffset":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":24}],
"accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[1,1,1]},
{"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}]})";
}

std::string glb(const std::string& node) { return glb_of(gltf_json("", node)); }

TEST_F(MeshFile, ReadsEveryKind) {
    expect_tetrahedron(read_mesh(write("a.obj", obj())));
    expect_tetrahedron(read_mesh(write("a.ply", ply_ascii())));
    expect_tetrahedron(read_mesh(write("little.ply", ply_binary(false))));
    expect_tetrahedron(read_mesh(write("big.PLY", ply_binary(true))));
    expect_tetrahedron(read_mesh(write("a.stl", stl_ascii())));
    expect_tetrahedron(read_mesh(write("b.stl", stl_binary("solid but binary"))));
    expect_tetrahedron(read_mesh(write("a.glb", glb(R"({"mesh":0})"))));
    expect_tetrahedron(read_mesh(write("a.3ds", three_ds())));
    write("a.bin", gltf_buffer());
    expect_tetrahedron(read_mesh(write("a.gltf", gltf_json(R"("uri":"a.bin",)", R"({"mesh":0})"))));
    EXPECT_EQ(read_mesh(folder_.file("a.obj")).name, "a.obj");
}

TEST_F(MeshFile, KeepsNormalsAndUvs) {
    const Mesh mesh = read_mesh(write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 2\n"
                                               "vt 0 0\nvt 1 0\nvt 0 1\nf 1/1/1 2/2/1 3/3/1\n"));
    ASSERT_EQ(mesh.normals.size(), 3U);
    EXPECT_EQ(mesh.normals[0], Vec3(0, 0, 1)); // normalised
    ASSERT_EQ(mesh.uvs.size(), 3U);
    EXPECT_EQ(mesh.uvs[1], Vec2f(1, 0));
}

TEST_F(MeshFile, DropsNonFiniteNormals) {
    const Mesh mesh = read_mesh(write(
        "a.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                 "property float z\nproperty float nx\nproperty float ny\nproperty float nz\n"
                 "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
                 "0 0 0 nan 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n"));
    EXPECT_TRUE(mesh.normals.empty());
}

TEST_F(MeshFile, Errors) {
    const std::string head = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                             "property float y\nproperty float z\nelement face 1\n"
                             "property list uchar int vertex_indices\nend_header\n";
    EXPECT_EQ(problem("a.ply", head + "0 0 0\n1 0 0\n0 nan 0\n3 0 1 2\n"),
              "a.ply: vertex 2 has a position that is not a number");
    EXPECT_EQ(problem("a.ply", head + "0 0 0\n1 0 0\n0 inf 0\n3 0 1 2\n"),
              "a.ply: vertex 2 has a position that is not a number");
    EXPECT_EQ(problem("a.ply", head + "0 0 0\n1 0 0\n0 1e30 0\n3 0 1 2\n"),
              "a.ply: vertex 2 lies more than 1e12 away");
    EXPECT_EQ(problem("a.ply", head + "0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n"),
              "a.ply: line 13: a face names vertex 3 of 3");
    EXPECT_EQ(problem("a.ply", head + "0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n"),
              "a.ply: line 13: a face names vertex -1 of 3");
    EXPECT_EQ(problem("a.ply", head + "0 0 0\n1 0 0\n0 1 0\n200 0 1 2\n"),
              "a.ply: line 13: a list has an impossible length");
    EXPECT_EQ(problem("a.ply", head + "0 0 0\n1 0 zero\n"),
              "a.ply: line 11: \"zero\" is not a number");
    EXPECT_EQ(problem("a.ply", head + "0 0 0\n1 0 0\n"),
              "a.ply: line 11: the file ends too early: its header counts 3 rows of vertex");
    EXPECT_EQ(problem("a.ply", "ply\nformat ascii 1.0\n"), "a.ply: its header has no end");
    EXPECT_EQ(problem("a.ply", ""), "a.ply: it is not a PLY file");
    EXPECT_EQ(problem("a.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"),
              "a.obj: line 1: \"nan\" is not a number");
    EXPECT_EQ(problem("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n"),
              "a.obj: line 4: a face names vertex 9 of 3");
    EXPECT_EQ(problem("a.obj", "v 0 0 0\n"), "a.obj: it has no triangles");
    EXPECT_EQ(problem("a.obj", ""), "a.obj: it has no triangles");
    EXPECT_EQ(problem("a.stl", "cut" + stl_binary("solid but binary").substr(3, 197)),
              "a.stl: it ends too early: its header promises 4 triangles, there is room for 2");
    EXPECT_EQ(problem("a.3ds", three_ds().substr(0, 60)), "a.3ds: it ends too early");
    EXPECT_EQ(problem("a.3ds", "no"), "a.3ds: it is not a 3DS file");
    EXPECT_EQ(problem("a.fbx", "x"), "a.fbx: is not a mesh that can be read; expected .obj, .ply, "
                                     ".stl, .gltf, .glb or .3ds");
    EXPECT_EQ(without_folder([&] { read_mesh(folder_.file("none.obj")); }),
              "none.obj: no such file");
}

// A 3DS file of a mesh with the given number of vertices and of texture coordinates, as its chunks
// count them, of which there are four and three.
std::string three_ds_counting(std::uint16_t vertices, std::uint16_t uvs) {
    std::string points;
    put(points, vertices);
    for (const auto& p : corner_points)
        for (const float x : p)
            put(points, x);
    std::string map;
    put(map, uvs);
    map.append(3 * 8, '\0');
    std::string face;
    put(face, std::uint16_t{1});
    for (const int i : {0, 1, 2, 0})
        put(face, static_cast<std::uint16_t>(i));
    const std::string mesh = chunk(0x4100, chunk(0x4110, points) + chunk(0x4120, face) +
                                               (uvs > 0 ? chunk(0x4140, map) : ""));
    return chunk(0x4d4d, chunk(0x3d3d, chunk(0x4000, std::string("a\0", 2) + mesh)));
}

TEST_F(MeshFile, CountsOf3dsChunks) {
    EXPECT_EQ(problem("a.3ds", three_ds_counting(4, 0)), "no error");
    EXPECT_EQ(problem("a.3ds", three_ds_counting(5, 0)),
              "a.3ds: a chunk counts 5 vertices, there is room for 4");
    EXPECT_EQ(problem("a.3ds", three_ds_counting(3, 0)),
              "a.3ds: a chunk counts 3 vertices, there is room for 4");
    EXPECT_EQ(problem("a.3ds", three_ds_counting(4, 9)),
              "a.3ds: a chunk counts 9 texture coordinates, there is room for 3");
    EXPECT_EQ(file_facts("a.3ds", three_ds_counting(4, 3)),
              "1 triangles; 3 texture coordinates for 4 vertices are not read");
}

TEST_F(MeshFile, HugeCountsAreRefusedAtOnce) {
    const std::string vertices = "property float x\nproperty float y\nproperty float z\n";
    EXPECT_EQ(problem("a.ply", "ply\nformat binary_little_endian 1.0\nelement vertex "
                               "18446744073709551615\n" +
                                   vertices + "end_header\n1234"),
              "a.ply: vertex 0: the file ends too early");
    EXPECT_EQ(problem("a.ply", "ply\nformat ascii 1.0\nelement nothing 18446744073709551615\n"
                               "element vertex 1\n" +
                                   vertices + "end_header\n0 0 0\n"),
              "a.ply: it has no triangles; not read: 18446744073709551615 rows of element "
              "\"nothing\"");
    std::string list = "ply\nformat binary_little_endian 1.0\nelement vertex 1\n" + vertices +
                       "element face 1\nproperty list double int vertex_indices\nend_header\n" +
                       std::string(12, '\0');
    put(list, 1e18);
    EXPECT_EQ(problem("a.ply", list), "a.ply: face 0: a list has an impossible length");
    std::string stl(80, ' ');
    put(stl, std::numeric_limits<std::uint32_t>::max());
    EXPECT_EQ(problem("a.stl", stl), "a.stl: it ends too early: its header promises 4294967295 "
                                     "triangles, there is room for 0");
}

TEST_F(MeshFile, ManyCornersAreOneFaceAndNoHang) {
    std::string polygon;
    std::string face = "f";
    for (int i = 0; i < 300; ++i) {
        const double angle = 2 * pi * i / 300;
        polygon +=
            "v " + std::to_string(std::cos(angle)) + " " + std::to_string(std::sin(angle)) + " 0\n";
        face += " " + std::to_string(i + 1);
    }
    EXPECT_EQ(read_mesh(write("a.obj", polygon + face + "\n")).triangles.size(), 298U);

    std::string fan = "ply\nformat ascii 1.0\nelement vertex 200000\nproperty float x\n"
                      "property float y\nproperty float z\nelement face 1\n"
                      "property list int int vertex_indices\nend_header\n";
    std::string corners = "200000";
    for (int i = 0; i < 200000; ++i) {
        fan += std::to_string(i) + " " + std::to_string(i % 7) + " 0\n";
        corners += " " + std::to_string(i);
    }
    Mesh mesh = read_mesh(write("fan.ply", fan + corners + "\n")); // it crosses itself often
    compute_normals(mesh, 1);
    for (const Vec3& n : mesh.normals)
        ASSERT_NEAR(n.length(), 1.0F, 1e-4F);
}

// Calls mesh.file with parameters as made by the scene reader.
Mesh make(const std::string& path, const std::vector<std::pair<std::string, Value>>& values = {}) {
    const auto table = mesh_file_table();
    Params params("mesh.file", {"toys.lua", 3});
    for (const ParamSpec& spec : table.plugins().front().params)
        params.set(spec.name, default_value(spec));
    params.set("path", path, {"toys.lua", 4});
    for (const auto& [key, value] : values)
        params.set(key, value);
    return table.plugins().front().make(params);
}

TEST_F(MeshFile, Plugin) {
    const std::string path = write("corner.obj", obj());
    const Mesh plain = make(path, {{"closed", true}});
    EXPECT_EQ(plain.name, "corner.obj");
    EXPECT_EQ(plain.normals.size(), plain.positions.size());
    const Mesh sized = make(path, {{"size", 0.5}});
    EXPECT_NEAR(bounds(sized).size().x, 0.5F, 1e-6F);
    EXPECT_EQ(bounds(sized).min.y, 0);
    // z up: the file's z becomes y, and its y becomes -z.
    const Mesh turned = make(path, {{"up", std::string("z")}});
    EXPECT_EQ(bounds(turned).min, Vec3(0, 0, -1));
    EXPECT_NEAR(volume(turned), 1.0 / 6, 1e-7);
}

TEST_F(MeshFile, UnitsAreConvertedToMetres) {
    const std::string text = "v 0 0 0\nv 5 0 0\nv 0 3 0\nf 1 2 3\n";
    const std::string obj = write("a.obj", text);
    for (const auto& [unit, metres] :
         {std::pair{"m", 1.0}, std::pair{"cm", 0.01}, std::pair{"mm", 0.001},
          std::pair{"in", 0.0254}, std::pair{"ft", 0.3048}})
        EXPECT_NEAR(bounds(make(obj, {{"unit", std::string(unit)}})).size().x, 5 * metres,
                    1e-6 * metres)
            << unit;
    EXPECT_EQ(bounds(make(obj)).size().x, 5);
    const Vec3 sized = bounds(make(obj, {{"unit", std::string("mm")}, {"size", 0.1}})).size();
    EXPECT_NEAR(sized.x, 0.1F, 1e-7F);
}

TEST_F(MeshFile, PluginErrorsAreLocated) {
    const std::string open = write("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_EQ(without_folder([&] {
                  make(open, {{"closed", true}});
              }),
              "toys.lua:4: mesh.file.path: open.obj: the mesh is open: 3 boundary edges, 0 "
              "non-manifold edges; expected a closed mesh");
    EXPECT_EQ(without_folder([&] { make(folder_.file("opne.obj")); }),
              "toys.lua:4: mesh.file.path: opne.obj: no such file\n  did you mean open.obj?");
    EXPECT_EQ(without_folder([&] { make(write("cut.stl", "solid")); }).find("toys.lua:4: "), 0U);
}

TEST_F(MeshFile, ReadsTheModelsOfGlmark2) {
    const std::string models = "/usr/share/glmark2/models/";
    if (!fs::exists(models))
        GTEST_SKIP() << "glmark2-data is not installed";
    for (const std::string name : {"bunny.obj", "horse.3ds", "cat.3ds"}) {
        const Mesh mesh = make(models + name, {{"size", 0.1}});
        EXPECT_GT(mesh.triangles.size(), 7000U) << name;
        EXPECT_GT(volume(mesh), 0) << name;
        const Vec3 size = bounds(mesh).size();
        EXPECT_NEAR(std::max({size.x, size.y, size.z}), 0.1F, 1e-6F) << name;
    }
}

} // namespace
} // namespace scree
