// SPDX-License-Identifier: GPL-3.0-or-later
// glTF files, built piece by piece.
#pragma once

#include "core/base64.h"
#include "core/math.h"
#include "tests/support/mesh_bytes.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace scree::tests {

using Json = nlohmann::json;

/// A glTF document and the data of its only buffer. Tests change `json` as they like.
struct GltfBuilder {
    Json json = {{"asset", {{"version", "2.0"}}}, {"scene", 0},
                 {"scenes", Json::array()},       {"nodes", Json::array()},
                 {"meshes", Json::array()},       {"accessors", Json::array()},
                 {"bufferViews", Json::array()}};
    std::string data;

    int view(const std::string& bytes) {
        data.resize((data.size() + 3) / 4 * 4);
        json["bufferViews"].push_back(
            {{"buffer", 0}, {"byteOffset", data.size()}, {"byteLength", bytes.size()}});
        data += bytes;
        return int(json["bufferViews"].size()) - 1;
    }

    int accessor(Json accessor) {
        json["accessors"].push_back(std::move(accessor));
        return int(json["accessors"].size()) - 1;
    }

    /// An accessor of `width` numbers an element; `code` is that of their type T.
    template <class T>
    int numbers(int code, std::size_t width, const std::vector<T>& values,
                bool normalized = false) {
        static const char* const types[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
        std::string bytes;
        for (const T value : values)
            put(bytes, value);
        return accessor({{"bufferView", view(bytes)},
                         {"componentType", code},
                         {"normalized", normalized},
                         {"count", values.size() / width},
                         {"type", width == 16 ? "MAT4" : types[width]}});
    }

    int floats(std::size_t width, const std::vector<float>& values) {
        return numbers<float>(5126, width, values);
    }
    int points(const std::vector<Vec3>& points) {
        std::vector<float> values;
        for (const Vec3& p : points)
            values.insert(values.end(), {p.x, p.y, p.z});
        return floats(3, values);
    }
    int indices(const std::vector<std::uint16_t>& values) {
        return numbers<std::uint16_t>(5123, 1, values);
    }

    /// A mesh of one primitive.
    int mesh(Json primitive) {
        json["meshes"].push_back({{"primitives", Json::array({std::move(primitive)})}});
        return int(json["meshes"].size()) - 1;
    }
    int node(Json node) {
        json["nodes"].push_back(std::move(node));
        return int(json["nodes"].size()) - 1;
    }
    void scene(const std::vector<int>& nodes) { json["scenes"].push_back({{"nodes", nodes}}); }

    /// The unit square in the plane y = 0 that faces up, as a primitive.
    Json square() {
        return {
            {"attributes", {{"POSITION", points({{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 0, 1}})}}},
            {"indices", indices({0, 1, 2, 2, 1, 3})}};
    }
    /// The tetrahedron of `corner_points`, of volume 1/6.
    Json corner() {
        std::vector<Vec3> at;
        for (const auto& p : corner_points)
            at.emplace_back(p[0], p[1], p[2]);
        std::vector<std::uint16_t> faces;
        for (const auto& f : corner_faces)
            faces.insert(faces.end(),
                         {std::uint16_t(f[0]), std::uint16_t(f[1]), std::uint16_t(f[2])});
        return {{"attributes", {{"POSITION", points(at)}}}, {"indices", indices(faces)}};
    }

    /// The file as .gltf, with its buffer inside.
    std::string text() const {
        Json out = json;
        if (!out.contains("buffers"))
            out["buffers"] = {{{"byteLength", data.size()},
                               {"uri", "data:application/octet-stream;base64," + base64(data)}}};
        return out.dump();
    }

    /// The file as .glb.
    std::string binary() const {
        Json out = json;
        out["buffers"] = {{{"byteLength", data.size()}}};
        std::string text = out.dump();
        text.resize((text.size() + 3) / 4 * 4, ' ');
        std::string bytes = data;
        bytes.resize((bytes.size() + 3) / 4 * 4);
        std::string file = "glTF";
        put(file, std::uint32_t{2});
        put(file, static_cast<std::uint32_t>(28 + text.size() + bytes.size()));
        put(file, static_cast<std::uint32_t>(text.size()));
        file += "JSON" + text;
        put(file, static_cast<std::uint32_t>(bytes.size()));
        return file + std::string("BIN\0", 4) + bytes;
    }
};

} // namespace scree::tests
