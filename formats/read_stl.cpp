// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/read_mesh.h"

#include "core/error.h"

#include <CGAL/IO/STL.h>
#include <CGAL/Simple_cartesian.h>

#include <array>
#include <bit>
#include <cstring>
#include <sstream>

namespace scree {

namespace {

constexpr std::size_t header_size = 84; // 80 bytes of text and the number of triangles
constexpr std::size_t record_size = 50;

bool is_binary(std::string_view bytes) {
    if (bytes.size() < header_size)
        return false;
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + 80, sizeof count);
    // Decided by the size, since many binary files begin with "solid" too.
    return bytes.size() == header_size + record_size * std::size_t{count} ||
           !bytes.starts_with("solid");
}

// Checks the number of triangles, since CGAL's reader does not.
void check_binary_size(std::string_view bytes) {
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + 80, sizeof count);
    if (bytes.size() < header_size + record_size * std::size_t{count})
        throw Error("it ends too early: its header promises " + std::to_string(count) +
                    " triangles, there is room for " +
                    std::to_string((bytes.size() - header_size) / record_size));
}

} // namespace

FileMesh read_stl(std::string_view bytes) {
    static_assert(std::endian::native == std::endian::little);
    using Point = CGAL::Simple_cartesian<float>::Point_3;
    if (is_binary(bytes))
        check_binary_size(bytes);
    std::istringstream in{std::string(bytes)};
    if (is_binary(bytes))
        CGAL::IO::set_binary_mode(in);
    std::vector<Point> points;
    std::vector<std::array<std::size_t, 3>> facets;
    if (!CGAL::IO::read_STL(in, points, facets))
        throw Error("it is damaged");
    FileMesh mesh;
    for (const Point& p : points)
        mesh.positions.emplace_back(p.x(), p.y(), p.z());
    for (const auto& f : facets)
        mesh.triangles.push_back({static_cast<std::uint32_t>(f[0]),
                                  static_cast<std::uint32_t>(f[1]),
                                  static_cast<std::uint32_t>(f[2])});
    return mesh;
}

} // namespace scree
