// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/mesh/mesh.h"

#include <memory>

namespace scree {

/// Directions of the unit sphere, joined by triangles of nearly one size: each face of an
/// icosahedron is divided into n^2, so that there are 20 n^2 triangles and 10 n^2 + 2 directions.
struct GeodesicSphere {
    double edge = 0; // about the length of an edge
    std::vector<WideVec3> directions;
    std::vector<Mesh::Triangle> triangles; // of directions, counter-clockwise from outside

    // UVs by the octahedral map, whose seams run down from the equator (y = 0) in the planes x = 0
    // and z = 0. A direction has several corners where triangles on either side of a seam use it.
    std::vector<std::uint32_t> direction_of_corner;
    std::vector<Vec2f> uvs;                       // of each corner
    std::vector<Mesh::Triangle> corner_triangles; // the same triangles, of corners
};

/// The sphere of 20 n^2 triangles, n from 1 to 128. Spheres are made once and kept.
std::shared_ptr<const GeodesicSphere> geodesic_sphere(int n);

} // namespace scree
