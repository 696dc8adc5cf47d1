// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/write_stl.h"

#include "core/error.h"
#include "core/file.h"
#include "core/version.h"
#include "formats/printer_frame.h"

#include <bit>
#include <cstring>
#include <limits>
#include <ostream>

namespace scree {

namespace {

constexpr std::size_t record_size = 50;

// A record: the normal, three corners and two attribute bytes, which are 0.
void put_triangle(char* out, const Mesh& mesh, const Mesh::Triangle& t) {
    std::array<Vec3, 4> vectors;
    for (std::size_t k = 0; k < 3; ++k)
        vectors[k + 1] = printer_position(mesh.positions[t[k]]);
    const Imath::V3d a(vectors[1]), b(vectors[2]), c(vectors[3]);
    vectors[0] = Vec3((b - a).cross(c - a).normalized());
    static_assert(sizeof vectors == 48 && std::endian::native == std::endian::little);
    std::memcpy(out, vectors.data(), sizeof vectors);
}

} // namespace

void write_stl(const std::string& path, const Mesh& mesh) {
    if (mesh.triangles.size() > std::numeric_limits<std::uint32_t>::max())
        throw Error::resource("cannot write " + path + ": it has more than 2^32 triangles");
    write_stream(path, [&](std::ostream& out) {
        // Must not begin with "solid", which marks a text file.
        std::string header = "Scree " SCREE_VERSION ", millimetres, z is up";
        header.resize(80, ' ');
        const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
        out.write(header.data(), std::streamsize(header.size()));
        out.write(reinterpret_cast<const char*>(&count), sizeof count);
        constexpr std::size_t batch = 4096;
        for (std::size_t first = 0; first < mesh.triangles.size(); first += batch) {
            const std::size_t end = std::min(mesh.triangles.size(), first + batch);
            std::string records((end - first) * record_size, '\0');
            for (std::size_t t = first; t < end; ++t)
                put_triangle(&records[(t - first) * record_size], mesh, mesh.triangles[t]);
            out.write(records.data(), std::streamsize(records.size()));
        }
    });
}

} // namespace scree
