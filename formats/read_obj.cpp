// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/read_mesh.h"

#include "core/error.h"

#include <tiny_obj_loader.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <tuple>

namespace scree {

namespace {

// OBJ indexes positions, normals and UVs separately; each combination used becomes one vertex.
class Vertices {
  public:
    explicit Vertices(const tinyobj::attrib_t& attributes) : attributes_(attributes) {}

    std::uint32_t add(const tinyobj::index_t& index) {
        check(index.vertex_index, attributes_.vertices.size() / 3);
        const auto key = std::tuple(index.vertex_index, index.normal_index, index.texcoord_index);
        const auto [entry, added] =
            known_.try_emplace(key, static_cast<std::uint32_t>(mesh.positions.size()));
        if (added)
            append(index);
        return entry->second;
    }

    FileMesh mesh;

  private:
    static void check(int index, std::size_t count) {
        if (index < 0 || std::size_t(index) >= count)
            throw Error("a face names vertex " + std::to_string(index + 1) + " of " +
                        std::to_string(count));
    }

    void append(const tinyobj::index_t& index) {
        const float* p = &attributes_.vertices[3 * std::size_t(index.vertex_index)];
        mesh.positions.emplace_back(p[0], p[1], p[2]);
        if (index.normal_index >= 0) {
            check(index.normal_index, attributes_.normals.size() / 3);
            const float* n = &attributes_.normals[3 * std::size_t(index.normal_index)];
            mesh.normals.emplace_back(n[0], n[1], n[2]);
        }
        if (index.texcoord_index >= 0) {
            check(index.texcoord_index, attributes_.texcoords.size() / 2);
            const float* t = &attributes_.texcoords[2 * std::size_t(index.texcoord_index)];
            mesh.uvs.emplace_back(t[0], t[1]);
        }
    }

    const tinyobj::attrib_t& attributes_;
    std::map<std::tuple<int, int, int>, std::uint32_t> known_;
};

// Rejects positions that are not numbers, which the library reads as 0.
void check_numbers(std::string_view bytes) {
    int line = 0;
    while (!bytes.empty()) {
        ++line;
        const std::size_t end = std::min(bytes.find('\n'), bytes.size());
        std::istringstream words;
        if (bytes.starts_with("v "))
            words.str(std::string(bytes.substr(2, std::min<std::size_t>(end, 400) - 2)));
        bytes.remove_prefix(std::min(end + 1, bytes.size()));
        std::string word;
        for (int k = 0; k < 3 && words >> word; ++k)
            if (word.find_first_not_of("0123456789+-.eE") != std::string::npos)
                throw Error("line " + std::to_string(line) + ": \"" + word.substr(0, 20) +
                            "\" is not a number");
    }
}

} // namespace

FileMesh read_obj(std::string_view bytes) {
    check_numbers(bytes);
    std::istringstream in{std::string(bytes)};
    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
    std::vector<tinyobj::material_t> materials;
    std::string warnings;
    std::string errors;
    // Faces are triangulated here: the library's ear clipping reads out of bounds for invalid
    // faces.
    if (!tinyobj::LoadObj(&attributes, &shapes, &materials, &warnings, &errors, &in, nullptr,
                          false))
        throw Error(errors.empty() ? "it is damaged" : errors.substr(0, errors.find('\n')));
    Vertices vertices(attributes);
    for (const tinyobj::shape_t& shape : shapes) {
        std::size_t corners_in_all = 0;
        for (const auto corners : shape.mesh.num_face_vertices)
            corners_in_all += corners;
        if (corners_in_all != shape.mesh.indices.size()) // older versions count corners in a byte
            throw Error("it has a face of more than 255 corners");
        std::size_t first = 0;
        for (const auto corners : shape.mesh.num_face_vertices) {
            for (std::size_t k = 2; k < corners; ++k)
                vertices.mesh.triangles.push_back(
                    {vertices.add(shape.mesh.indices.at(first)),
                     vertices.add(shape.mesh.indices.at(first + k - 1)),
                     vertices.add(shape.mesh.indices.at(first + k))});
            first += corners;
        }
    }
    return std::move(vertices.mesh);
}

} // namespace scree
