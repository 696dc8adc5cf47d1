// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace scree {

/// The header of a PLY file (Turk 1994).
struct PlyHeader {
    enum class Encoding { ascii, little, big };
    enum class Scalar { i8, u8, i16, u16, i32, u32, f32, f64 };

    struct Property {
        std::string name;
        Scalar type = Scalar::f32;
        std::optional<Scalar> count; // of a list
    };

    struct Element {
        std::string name;
        std::size_t count = 0; // of rows
        std::vector<Property> properties;
    };

    Encoding encoding = Encoding::ascii;
    std::vector<Element> elements; // in the order of their rows
    std::size_t lines = 0;         // of the header
    std::string_view body;         // the rows
};

/// Throws Error (input) that names the line of what is wrong.
PlyHeader parse_ply_header(std::string_view bytes);

} // namespace scree
