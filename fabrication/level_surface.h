// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fabrication/distance_field.h"
#include "geometry/mesh/mesh.h"

namespace scree {

/// A vertex on a lattice line parallel to z. Along a line, the crossings of closed surfaces
/// alternate between entering and leaving.
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

/// The level set of the field at `level`, facing higher values. For any field it is a closed
/// 2-manifold without self-intersections: it has one vertex on each lattice edge that it crosses,
/// at least a fiftieth of the edge away from its ends, and in each cell the triangles of
/// cell_surface. The level must be 0 or at least 1.75 inside the field's limits. Throws Error
/// (resource) for more vertices than 32-bit indices allow.
LevelSurface level_surface(const DistanceField& field, double level);

} // namespace scree
