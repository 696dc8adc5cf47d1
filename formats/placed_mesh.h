// SPDX-License-Identifier: GPL-3.0-or-later
// Moves and scales the mesh of a file while its positions are in double precision.
#pragma once

#include "formats/file_mesh.h"

#include <optional>

namespace scree {

/// Turns the mesh by -90 degrees about x: its z axis becomes y.
void turn_z_up(FileMesh& mesh);

/// The longest side of the mesh's bounding box.
double longest_side(const FileMesh& mesh);

/// Multiplies all positions.
void scale(FileMesh& mesh, double factor);

/// Moves the mesh so that its bounding box is centred on the y axis and stands on y = 0; with a
/// `size` also scales it so that its longest side is that long [m].
void centre(FileMesh& mesh, std::optional<double> size);

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
