// SPDX-License-Identifier: GPL-3.0-or-later
// 3D Studio's binary format: chunks of a 16-bit kind, a 32-bit length that includes these six
// bytes, and the content. All meshes are merged; their vertices are in the scene's frame.
#include "formats/read_mesh.h"

#include "core/error.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstring>

namespace scree {

namespace {

enum Kind : std::uint16_t {
    file = 0x4d4d,
    scene = 0x3d3d,
    object = 0x4000,
    triangle_mesh = 0x4100,
    vertices = 0x4110,
    faces = 0x4120,
    map_coordinates = 0x4140,
};

// Reads numbers one after the other with bounds checks.
class Bytes {
  public:
    explicit Bytes(std::string_view bytes) : rest_(bytes) {}

    bool empty() const { return rest_.empty(); }
    std::size_t size() const { return rest_.size(); }

    std::string_view take(std::size_t size) {
        if (size > rest_.size())
            throw Error("it ends too early");
        const std::string_view out = rest_.substr(0, size);
        rest_.remove_prefix(size);
        return out;
    }

    template <class T>
    T number() {
        static_assert(std::endian::native == std::endian::little);
        T value{};
        std::memcpy(&value, take(sizeof(T)).data(), sizeof(T));
        return value;
    }

    void skip_text() {
        while (number<char>() != '\0') {
        }
    }

  private:
    std::string_view rest_;
};

// A count, checked against the bytes that follow it. `exact`: nothing else may follow.
std::size_t count_of(Bytes& bytes, const char* what, std::size_t record, bool exact) {
    const std::size_t count = bytes.number<std::uint16_t>();
    const std::size_t room = bytes.size() / record;
    if (count > room || (exact && count < room))
        throw Error(fmt::format("a chunk counts {} {}, there is room for {}", count, what, room));
    return count;
}

void read_vertices(Bytes bytes, FileMesh& mesh) {
    const std::size_t count = count_of(bytes, "vertices", 12, true);
    for (std::size_t i = 0; i < count; ++i) {
        const auto p = bytes.number<std::array<float, 3>>();
        mesh.positions.emplace_back(p[0], p[1], p[2]);
    }
}

void read_faces(Bytes bytes, FileMesh& mesh) {
    const std::size_t count = count_of(bytes, "faces", 8, false); // materials follow them
    for (std::size_t i = 0; i < count; ++i) {
        const auto face = bytes.number<std::array<std::uint16_t, 4>>(); // the last holds flags
        mesh.triangles.push_back({face[0], face[1], face[2]});
    }
}

void read_map(Bytes bytes, FileMesh& mesh) {
    const std::size_t count = count_of(bytes, "texture coordinates", 8, true);
    for (std::size_t i = 0; i < count; ++i) {
        const auto uv = bytes.number<std::array<float, 2>>();
        mesh.uvs.emplace_back(uv[0], uv[1]);
    }
}

void finish_part(FileMesh& mesh, FileMesh part) {
    for (const Mesh::Triangle& t : part.triangles)
        for (const std::uint32_t index : t)
            if (index >= part.positions.size())
                throw Error("a face names vertex " + std::to_string(index) + " of " +
                            std::to_string(part.positions.size()));
    if (!part.uvs.empty() && part.uvs.size() != part.positions.size()) {
        part.warnings.push_back(fmt::format("{} texture coordinates for {} vertices are not read",
                                            part.uvs.size(), part.positions.size()));
        part.uvs.clear();
    }
    append(mesh, std::move(part));
}

// Each kind of chunk is entered from one parent kind only, so the recursion ends.
void read_chunks(Bytes bytes, std::uint16_t parent, FileMesh& mesh) {
    while (!bytes.empty()) {
        const auto kind = bytes.number<std::uint16_t>();
        const auto length = bytes.number<std::uint32_t>();
        if (length < 6)
            throw Error("it has a chunk of an impossible length");
        Bytes body(bytes.take(length - 6));
        if (parent == 0 && kind == file) {
            read_chunks(body, file, mesh);
        } else if (parent == file && kind == scene) {
            read_chunks(body, scene, mesh);
        } else if (parent == scene && kind == object) {
            body.skip_text();
            read_chunks(body, object, mesh);
        } else if (parent == object && kind == triangle_mesh) {
            FileMesh part;
            read_chunks(body, triangle_mesh, part);
            finish_part(mesh, std::move(part));
        } else if (parent == triangle_mesh && kind == vertices) {
            read_vertices(body, mesh);
        } else if (parent == triangle_mesh && kind == faces) {
            read_faces(body, mesh);
        } else if (parent == triangle_mesh && kind == map_coordinates) {
            read_map(body, mesh);
        }
    }
}

} // namespace

FileMesh read_3ds(std::string_view bytes) {
    if (!bytes.starts_with("MM"))
        throw Error("it is not a 3DS file");
    FileMesh mesh;
    read_chunks(Bytes(bytes), 0, mesh);
    return mesh;
}

} // namespace scree
