// SPDX-License-Identifier: GPL-3.0-or-later
// The bytes of small mesh files: the corner of a unit cube, which is a tetrahedron.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string>

namespace scree::tests {

// The origin and the ends of the three axes.
inline constexpr float corner_points[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
inline constexpr int corner_faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

/// Appends the bytes of a number, least first unless `big`.
template <class T>
void put(std::string& out, T value, bool big = false) {
    std::array<char, sizeof(T)> raw{};
    std::memcpy(raw.data(), &value, sizeof(T));
    if (big)
        std::reverse(raw.begin(), raw.end());
    out.append(raw.data(), raw.size());
}

inline std::string stl_ascii() {
    std::string out = "solid corner\n";
    for (const auto& f : corner_faces) {
        out += " facet normal 0 0 0\n  outer loop\n";
        for (const int i : f) {
            out += "   vertex";
            for (const float x : corner_points[i])
                out += " " + std::to_string(x);
            out += "\n";
        }
        out += "  endloop\n endfacet\n";
    }
    return out + "endsolid corner\n";
}

/// `title` fills the header, which readers ignore.
inline std::string stl_binary(std::string title = "") {
    std::string out = std::move(title);
    out.resize(80, ' ');
    put(out, std::uint32_t{4});
    for (const auto& f : corner_faces) {
        out.append(12, '\0'); // the normal
        for (const int i : f)
            for (const float x : corner_points[i])
                put(out, x);
        put(out, std::uint16_t{0});
    }
    return out;
}

/// The positions (48 bytes) and indices (24 bytes) that the JSON of a glTF file refers to.
inline std::string gltf_buffer() {
    std::string out;
    for (const auto& p : corner_points)
        for (const float x : p)
            put(out, x);
    for (const auto& f : corner_faces)
        for (const int i : f)
            put(out, static_cast<std::uint16_t>(i));
    return out;
}

/// A GLB file of that JSON and `gltf_buffer`.
inline std::string glb_of(std::string json) {
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const std::string buffer = gltf_buffer();
    std::string out = "glTF";
    put(out, std::uint32_t{2});
    put(out, static_cast<std::uint32_t>(28 + json.size() + buffer.size()));
    put(out, static_cast<std::uint32_t>(json.size()));
    out += "JSON" + json;
    put(out, static_cast<std::uint32_t>(buffer.size()));
    return out + std::string("BIN\0", 4) + buffer;
}

/// A chunk of a 3DS file.
inline std::string chunk(std::uint16_t kind, const std::string& body) {
    std::string out;
    put(out, kind);
    put(out, static_cast<std::uint32_t>(body.size() + 6));
    return out + body;
}

inline std::string three_ds() {
    std::string vertices;
    put(vertices, std::uint16_t{4});
    for (const auto& p : corner_points)
        for (const float x : p)
            put(vertices, x);
    std::string triangles;
    put(triangles, std::uint16_t{4});
    for (const auto& f : corner_faces) {
        for (const int i : f)
            put(triangles, static_cast<std::uint16_t>(i));
        put(triangles, std::uint16_t{0});
    }
    const std::string mesh = chunk(0x4100, chunk(0x4110, vertices) + chunk(0x4120, triangles));
    return chunk(0x4d4d, chunk(0x3d3d, chunk(0x4000, std::string("corner\0", 7) + mesh)));
}

} // namespace scree::tests
