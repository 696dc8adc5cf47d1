// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/mesh/mesh.h"

#include <cstdint>
#include <vector>

namespace scree::fibres {

/// For each cell of a cubic grid the vertices of a mesh that can be nearest to a point in it, so
/// that the nearest one of any such point is found exactly among few.
struct NearestVertices {
    static constexpr int side = 64; // cells along each axis

    Vec3 corner;                       // where x, y and z are least [m]
    float cell = 1;                    // side of a cell [m]
    std::vector<float> surface;        // of each vertex its position [m] and its outward normal
    std::vector<std::int32_t> first;   // of each cell's part of `nearest`, x fastest, and the end
    std::vector<std::int32_t> nearest; // vertices

    /// The grid covers the mesh's box with `margin` [m] all around.
    NearestVertices(const Mesh& mesh, double margin);
};

} // namespace scree::fibres
