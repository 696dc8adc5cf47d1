// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fabrication/distance_field.h"
#include "geometry/mesh/mesh.h"

namespace scree {

/// A vertex on a lattice line along z, which closed surfaces cross in turn: in, out, in, out.
struct LineVertex {
    int x = 0;
    int y = 0;
    double z = 0;
    std::uint32_t vertex = 0;
};

struct LevelSurface {
    std::vector<Imath::V3d> positions; // in units of the lattice
    std::vector<Mesh::Triangle> triangles;
    std::vector<LineVertex> line_vertices;
};

/// The surface where the field has the value `level`, outward normals towards higher values. It is
/// a closed 2-manifold that does not meet itself, whatever the field: a vertex per crossed edge of
/// the lattice, never nearer to its ends than a fiftieth, and in each cell the triangles of
/// cell_surface. The level is at least 1.75 within the field's limits, or 0. Throws Error
/// (resource) for more vertices than 32 bits count.
LevelSurface level_surface(const DistanceField& field, double level);

} // namespace scree
