// SPDX-License-Identifier: GPL-3.0-or-later
// STL (3D Systems 1989): text, or binary of 84 bytes and 50 for each triangle. Normals are computed
// from the corners; colours in the attribute bytes are decoration without a standard.
#include "formats/read_mesh.h"
#include "formats/stl_text.h"
#include "formats/vertex_merger.h"

#include "core/error.h"
#include "core/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace scree {

namespace {

constexpr std::size_t header_size = 84; // 80 bytes of text and the number of triangles
constexpr std::size_t record_size = 50;

std::size_t count_of(std::string_view bytes) {
    static_assert(std::endian::native == std::endian::little);
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + 80, sizeof count);
    return count;
}

// Decided by the size first, since many binary files begin with "solid" too.
bool is_binary(std::string_view bytes) {
    if (bytes.size() >= header_size && bytes.size() == header_size + record_size * count_of(bytes))
        return true;
    return !is_stl_text(bytes);
}

void check_binary_size(std::string_view bytes, FileMesh& mesh) {
    if (bytes.size() < header_size)
        throw Error(fmt::format("it has {}; a binary file has at least {}",
                                counted(bytes.size(), "byte"), header_size));
    const std::size_t room = (bytes.size() - header_size) / record_size;
    const std::size_t count = count_of(bytes);
    if (room < count)
        throw Error(fmt::format("it ends too early: its header promises {}, there is room for {}",
                                counted(count, "triangle"), room));
    if (room > count)
        throw Error(fmt::format("it goes on after the {} that its header promises: there is room "
                                "for {}",
                                counted(count, "triangle"), room));
    if (const std::size_t rest = (bytes.size() - header_size) % record_size; rest > 0)
        mesh.warnings.push_back("not read: " + counted(rest, "byte") + " at its end");
}

void read_binary(std::string_view bytes, FileMesh& mesh) {
    check_binary_size(bytes, mesh);
    VertexMerger merger(mesh);
    for (std::size_t i = 0; i < count_of(bytes); ++i) {
        std::array<float, 9> p{}; // after the normal
        std::memcpy(p.data(), bytes.data() + header_size + i * record_size + 12, sizeof p);
        mesh.triangles.push_back({merger.add(Imath::V3d(p[0], p[1], p[2])),
                                  merger.add(Imath::V3d(p[3], p[4], p[5])),
                                  merger.add(Imath::V3d(p[6], p[7], p[8]))});
    }
}

} // namespace

FileMesh read_stl(std::string_view bytes) {
    FileMesh mesh;
    if (is_binary(bytes))
        read_binary(bytes, mesh);
    else
        read_stl_text(bytes, mesh);
    return mesh;
}

} // namespace scree
