// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace scree {

/// The triangles of a face of a mesh, as indices of its corners.
struct FaceTriangles {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    bool crosses_itself = false; // seen along its normal; the triangles are those of its parts
};

/// Triangulates a polygon in space in its plane of best fit, whose normal is Newell's (Sutherland,
/// Sproull & Schumacker 1974, appendix). The polygon may be concave, touch itself and repeat
/// corners, as those with holes do that are joined to the outside by a bridge. The triangles turn
/// as the polygon does and cover the points around which it winds. Three corners, and those without
/// an area, give the triangles of a fan, so that a closed mesh stays closed. `corners` holds at
/// least three finite points.
FaceTriangles triangulate_face(std::span<const Imath::V3d> corners);

} // namespace scree
