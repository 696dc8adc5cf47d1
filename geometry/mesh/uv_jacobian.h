// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/mesh/mesh.h"

namespace scree {

/// What one unit of u and of v is on a triangle of a mesh with UVs.
struct UvJacobian {
    Imath::V3d cross{0.0, 0.0, 0.0}; // of the edges: twice the area along the face's normal
    Imath::V3d along_u{0.0, 0.0, 0.0};
    Imath::V3d along_v{0.0, 0.0, 0.0};
    double turn = 0; // of the triangle in UV: > 0 upright, < 0 mirrored, 0 without area

    UvJacobian(const Mesh& mesh, const Mesh::Triangle& t) {
        const Imath::V3d a(mesh.positions[t[0]]);
        const Imath::V3d p = Imath::V3d(mesh.positions[t[1]]) - a;
        const Imath::V3d q = Imath::V3d(mesh.positions[t[2]]) - a;
        const Vec2 origin(mesh.uvs[t[0]]);
        const Vec2 e = Vec2(mesh.uvs[t[1]]) - origin, f = Vec2(mesh.uvs[t[2]]) - origin;
        cross = p.cross(q);
        turn = scree::cross(e, f);
        if (turn == 0)
            return;
        along_u = (p * f.y - q * e.y) / turn;
        along_v = (q * e.x - p * f.x) / turn;
    }
};

} // namespace scree
