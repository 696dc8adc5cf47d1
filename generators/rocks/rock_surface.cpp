// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/rocks/rock_surface.h"

#include "geometry/rock/geodesic_sphere.h"
#include "geometry/rock/rock.h"

#include <algorithm>

namespace scree::rocks {

namespace {

WideVec3 centre_of_mass(const std::vector<WideVec3>& vertices,
                        const std::vector<Mesh::Triangle>& triangles) {
    WideVec3 moment(0, 0, 0);
    double volume = 0;
    for (const Mesh::Triangle& t : triangles) {
        const WideVec3& a = vertices[t[0]];
        const WideVec3& b = vertices[t[1]];
        const WideVec3& c = vertices[t[2]];
        const double part = a ^ b.cross(c); // six times that of the tetrahedron with the origin
        volume += part;
        moment += (a + b + c) * (part / 4);
    }
    return moment / volume;
}

} // namespace

RockSurface make_rock_surface(const RockSettings& settings, int level, std::string name) {
    const std::vector<WideVec3> vertices = Rock(settings).vertices(level);
    RockSurface surface;
    Mesh mesh = rock_mesh(vertices, level);
    mesh.name = std::move(name);
    surface.mesh = std::make_shared<const Mesh>(std::move(mesh));
    surface.triangles = geodesic_sphere(level)->triangles;
    surface.centre = Vec3(centre_of_mass(vertices, surface.triangles));
    surface.vertices.reserve(vertices.size());
    for (const WideVec3& v : vertices) {
        surface.vertices.push_back(Vec3(v) - surface.centre);
        surface.reach = std::max(surface.reach, surface.vertices.back().length());
    }
    return surface;
}

Imath::M33d turned(const Imath::M33d& rows, const Rotation& rotation) {
    Imath::M33d out;
    for (int i = 0; i < 3; ++i) {
        const WideVec3 row = rotation(WideVec3(rows[i][0], rows[i][1], rows[i][2]));
        for (int k = 0; k < 3; ++k)
            out[i][k] = row[k];
    }
    return out;
}

void pose_vertices(const RockSurface& surface, const Imath::M33d& world_from_rock, double scale,
                   std::vector<Vec3>& out) {
    const Imath::M33f turn(world_from_rock * scale);
    out.resize(surface.vertices.size());
    std::transform(surface.vertices.begin(), surface.vertices.end(), out.begin(),
                   [&](const Vec3& v) { return v * turn; });
}

WideMatrix world_from_mesh(const PlacedRock& rock, const RockSurface& surface) {
    const Imath::M33d m = rock.world_from_rock * rock.scale;
    const WideVec3 at = rock.centre - WideVec3(surface.centre) * m;
    return {m[0][0], m[0][1], m[0][2], 0, m[1][0], m[1][1], m[1][2], 0,
            m[2][0], m[2][1], m[2][2], 0, at.x,    at.y,    at.z,    1};
}

} // namespace scree::rocks
