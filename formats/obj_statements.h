// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"
#include "formats/read_mtl.h"
#include "formats/text_lines.h"

#include <array>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace scree {

/// The 0-based indices of a position, a texture coordinate and a normal; Obj::absent for none.
using ObjCorner = std::array<std::int32_t, 3>;

/// What the statements of an OBJ file say. All indices of corners are in range.
struct Obj {
    static constexpr std::int32_t absent = -1;

    struct Face {
        std::size_t first = 0; // of its corners
        std::size_t count = 0; // at least 3
        std::size_t line = 0;
        std::uint16_t material = 0; // a number in `materials`
    };

    std::vector<Imath::V3d> positions; // finite
    std::vector<Vec2f> uvs;
    std::vector<Vec3> normals;
    std::vector<ObjCorner> corners; // of all faces and lines
    std::vector<Face> faces;
    std::vector<Face> lines;             // of two corners or more, without material
    std::vector<std::string> libraries;  // what stands behind each mtllib
    std::vector<MaterialUse> materials;  // the names that faces use; "" for none
    std::map<std::string, Tally> unread; // "lines", with the lines where they stand

    std::span<const ObjCorner> corners_of(const Face& face) const {
        return std::span(corners).subspan(face.first, face.count);
    }
    std::array<std::size_t, 3> counts() const {
        return {positions.size(), uvs.size(), normals.size()};
    }
};

/// Reads all statements. Throws Error (input) that names the line of what is wrong or cannot be
/// read.
Obj parse_obj(std::string_view bytes);

} // namespace scree
