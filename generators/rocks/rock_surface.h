// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/bodies/pose.h"
#include "geometry/mesh/mesh.h"
#include "geometry/rock/rock_settings.h"

#include <memory>

namespace scree::rocks {

/// One rock at one level of detail: the mesh that is shown, which is also the one that touches
/// others. Half of its longest axis is 1.
struct RockSurface {
    std::shared_ptr<const Mesh> mesh; // in the frame of `Rock`

    // As it collides: each vertex once, with the centre of mass as the origin.
    Vec3 centre; // of mass, in the mesh's frame
    std::vector<Vec3> vertices;
    std::vector<Mesh::Triangle> triangles;
    float reach = 0; // from the centre of mass to the farthest vertex
};

RockSurface make_rock_surface(const RockSettings& settings, int level, std::string name);

/// A rock in its place.
struct PlacedRock {
    std::uint32_t surface = 0;   // its number among the surfaces
    double scale = 1;            // half of its longest axis [m]
    WideVec3 centre{0, 0, 0};    // of mass [m]
    Imath::M33d world_from_rock; // a rotation; its rows are the images of the rock's axes
    bool placed = false;         // false: no place was found
};

/// The rows of a rotation, turned.
Imath::M33d turned(const Imath::M33d& rows, const Rotation& rotation);

/// The vertices turned and scaled, relative to the centre of mass [m].
void pose_vertices(const RockSurface& surface, const Imath::M33d& world_from_rock, double scale,
                   std::vector<Vec3>& out);

/// The matrix that places the mesh.
WideMatrix world_from_mesh(const PlacedRock& rock, const RockSurface& surface);

} // namespace scree::rocks
