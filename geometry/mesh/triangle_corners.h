// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/mesh/mesh.h"

#include <array>

namespace scree {

inline std::array<Vec3, 3> corners_of(const Mesh& mesh, std::size_t triangle) {
    const Mesh::Triangle& t = mesh.triangles[triangle];
    return {mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]};
}

} // namespace scree
