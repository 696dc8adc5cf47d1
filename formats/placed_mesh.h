// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/file_mesh.h"

namespace scree {

/// What single precision does to the positions of a mesh.
struct Rounding {
    double moved = 0;     // the most that a vertex moves along an axis
    double distance = 0;  // of the vertex that is farthest from the origin
    double longest = 0;   // side of the bounding box
    double mean_edge = 0; // of the triangles

    /// Whether it shows: by more than a pixel of a picture of 10,000, or in the shading, by bending
    /// faces of mean size by about three degrees.
    bool shows() const { return moved > 1e-4 * longest || moved > 0.05 * mean_edge; }
};
Rounding rounding(const FileMesh& mesh);

} // namespace scree
