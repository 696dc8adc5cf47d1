// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/mesh_seeds.h"

#include "formats/read_mesh.h"
#include "tests/support/gltf_builder.h"
#include "tests/support/mesh_bytes.h"

namespace scree {

namespace {

using namespace tests;

std::string obj() {
    return "mtllib a.mtl\no corner\nv 0 0 0\nv 1 0 0 1\nv 0 1 0\nv 0 0 1\nvn 0 0 1\nvt 0.5 1\n"
           "usemtl red\ns 1\nf 1/1/1 3/1/1 2/1/1\nf 1//1 2//1 4//1\ng b\nf -4 -1 -2\nf 2 3 4 1\n";
}

std::string ply_ascii() {
    return "ply\nformat ascii 1.0\ncomment by hand\nelement vertex 4\nproperty float x\n"
           "property float y\nproperty double z\nproperty uchar red\nelement face 4\n"
           "property list uchar int vertex_indices\nelement edge 1\nproperty int a\nend_header\n"
           "0 0 0 1\n1 0 0 2\n0 1 0 3\n0 0 1 4\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n7\n";
}

std::string ply_strips() {
    return "ply\rformat ascii 1.0\relement vertex 5\rproperty double x\rproperty double y\r"
           "property double z\rproperty float s\rproperty float t\relement tristrips 1\r"
           "property list int int vertex_indices\relement face 1\r"
           "property list uchar uint vertex_index\rend_header\r"
           "5e6 0 0 0 0\r5e6 1 0 0 1\r5000001 0 0 1 0\r5000001 1 0 1 1\r5000000.5 0.5 0 0 0\r"
           "9 0 1 2 3 3 -1 0 1 4\r5 0 2 3 4 1\r";
}

// Faces of many corners: concave, with a bridge to a hole, and one that crosses itself.
std::string obj_faces() {
    return "\xef\xbb\xbfv 0 0 0\nv\t4 0 0\n v 4 4 0 \\\n\nv 0 4 0\nv 1 1 0 1 .5 .5\nv 1 3 0\n"
           "v 3 3 0\nv 3 1 0\nf 1 2 3 4 1 5 6 7 8 5\nf -8 -7 -4 -6 -5\nf 1// 3// \\\n2// 4//\nl 1 "
           "2\n";
}

std::string stl_words() {
    return "\n Solid of two\r\nFACET NORMAL 0 0 1\tOUTER LOOP VERTEX 0 0 0 VERTEX 1e0 0 0 "
           "vertex 1 1 0 vertex 0 1 0 endloop endfacet\nendsolid of two\nsolid\nfacet outer loop\n"
           "vertex 0 0 0\nvertex 1 0 0\nvertex 0 0 1\nendloop\nendfacet\nendsolid\n";
}

std::string ply_binary(bool big) {
    std::string out = std::string("ply\nformat binary_") + (big ? "big" : "little") +
                      "_endian 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                      "property double z\nproperty list ushort short tags\nelement face 4\n"
                      "property list uint8 int32 vertex_index\nend_header\n";
    for (const auto& p : corner_points) {
        put(out, p[0], big);
        put(out, p[1], big);
        put(out, double(p[2]), big);
        put(out, std::uint16_t{1}, big);
        put(out, std::int16_t{-5}, big);
    }
    for (const auto& f : corner_faces) {
        put(out, std::uint8_t{3});
        for (const int i : f)
            put(out, std::int32_t{i}, big);
    }
    return out;
}

std::string gltf_json(const std::string& buffer) {
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
"nodes":[{"children":[1],"scale":[1,2,1]},{"mesh":0,"rotation":[0,0,0,1],"translation":[1,0,0]}],
"materials":[{"pbrMetallicRoughness":{"baseColorFactor":[1,0,0,1]}}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"material":0}]}],
"buffers":[{)" +
           buffer + R"("byteLength":72}],"bufferViews":[{"buffer":0,"byteLength":48},
{"buffer":0,"byteOffset":48,"byteLength":24}],"accessors":[
{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[1,1,1]},
{"bufferView":1,"componentType":5123,"count":12,"type":"SCALAR"}]})";
}

// Of everything that a file can have: strips, morphs, a skin, instances, sparse data, materials.
GltfBuilder rich_gltf() {
    GltfBuilder file;
    Json strip = file.square();
    strip["mode"] = 5;
    strip["attributes"]["NORMAL"] = file.points({4, Vec3(0, 1, 0)});
    strip["attributes"]["TEXCOORD_0"] =
        file.numbers<std::uint8_t>(5121, 2, {0, 0, 255, 0, 0, 255, 255, 255}, true);
    strip["attributes"]["JOINTS_0"] =
        file.numbers<std::uint8_t>(5121, 4, {0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0});
    strip["attributes"]["WEIGHTS_0"] =
        file.floats(4, {1, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 0.5F, 0.5F, 0, 0});
    const int change = file.accessor({{"componentType", 5126}, {"count", 4}, {"type", "VEC3"}});
    const int at = file.view(std::string("\1\3", 2));
    const int values = file.view(std::string(24, '\x3f'));
    file.json["accessors"][std::size_t(change)]["sparse"] = {
        {"count", 2},
        {"indices", {{"bufferView", at}, {"componentType", 5121}}},
        {"values", {{"bufferView", values}}}};
    strip["targets"] = {{{"POSITION", change}}};
    strip["material"] = 0;
    file.mesh(strip);
    file.json["meshes"][0]["weights"] = {0.5};
    file.mesh(file.corner());
    file.json["skins"] = {{{"joints", {1, 2}}}};
    file.node({{"mesh", 0}, {"skin", 0}});
    file.node({{"children", {2}}, {"rotation", {0, 0, 0.6, 0.8}}});
    file.node({{"matrix", {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, -2, 0, 1, 2, 3, 1}}});
    const Json attributes = {{"TRANSLATION", file.floats(3, {0, 0, 0, 9, 0, 0})}};
    file.node({{"mesh", 1},
               {"scale", {1, 0, 1}},
               {"extensions", {{"EXT_mesh_gpu_instancing", {{"attributes", attributes}}}}}});
    file.scene({0, 1, 3});
    file.json["images"] = {{{"bufferView", 0}}};
    file.json["samplers"] = {{{"wrapS", 33071}}};
    file.json["textures"] = {{{"source", 0}, {"sampler", 0}}};
    file.json["materials"] = {
        {{"pbrMetallicRoughness",
          {{"baseColorFactor", {1, 0, 0, 1}},
           {"baseColorTexture",
            {{"index", 0}, {"extensions", {{"KHR_texture_transform", {{"rotation", 1}}}}}}}}}}};
    return file;
}

std::string gltf() {
    return gltf_json(R"("uri":"data:application/octet-stream;base64,)" + base64(gltf_buffer()) +
                     R"(",)");
}

MeshSeed seed(const std::string& name, const std::string& ending, std::string bytes) {
    return {name, std::move(bytes),
            [ending](std::string_view given) { return read_mesh_bytes("x." + ending, given); }};
}

} // namespace

std::vector<MeshSeed> mesh_seeds() {
    return {seed("obj", "obj", obj()),
            seed("obj_faces", "obj", obj_faces()),
            seed("ply_ascii", "ply", ply_ascii()),
            seed("ply_strips", "ply", ply_strips()),
            seed("ply_little", "ply", ply_binary(false)),
            seed("ply_big", "ply", ply_binary(true)),
            seed("stl_ascii", "stl", stl_ascii()),
            seed("stl_words", "stl", stl_words()),
            seed("stl_binary", "stl", stl_binary()),
            seed("gltf", "gltf", gltf()),
            seed("glb", "glb", glb_of(gltf_json(""))),
            seed("gltf_rich", "gltf", rich_gltf().text()),
            seed("glb_rich", "glb", rich_gltf().binary()),
            seed("3ds", "3ds", three_ds())};
}

} // namespace scree
