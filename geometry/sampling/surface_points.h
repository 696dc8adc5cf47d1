// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/mesh/mesh.h"

#include <vector>

namespace scree {

/// Points on a mesh with the outward normals of their triangles.
struct SurfacePoints {
    std::vector<Vec3> positions;
    std::vector<Vec3> normals;
};

/// Evenly spread over the surface: no two points are nearer than `spacing` [m] to each other, and
/// no point of the surface is farther than that from all of them.
SurfacePoints surface_points(const Mesh& mesh, double spacing);

/// The spacing at which `surface_points` has about `count` points.
double spacing_for(const Mesh& mesh, double count);

/// Points not farther than `spacing` [m] apart along the edges where faces meet at more than 30
/// degrees, or that only one face has; their ends among them.
std::vector<Vec3> edge_points(const Mesh& mesh, double spacing);

} // namespace scree
