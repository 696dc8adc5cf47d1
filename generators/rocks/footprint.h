// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/mesh/mesh.h"

#include <span>

namespace scree::rocks {

enum class Side { under, top };

/// The cell in which a place is, in sides of a cell from the middle of cell 0.
inline int nearest_cell(float cells) {
    const float shifted = cells + 0.5F;
    const int towards_zero = static_cast<int>(shifted); // std::floor is a call without SSE 4.1
    return towards_zero - (shifted < static_cast<float>(towards_zero) ? 1 : 0);
}

/// The underside or the top of a posed rock on a grid of square cells, one of which has the rock's
/// centre in its middle. It is conservative: every cell that the rock touches from above holds a
/// height that no point of the rock in it is below (or, of the top, above).
struct Footprint {
    int first_x = 0; // of the cell at index 0, counted from the centre's cell
    int first_z = 0;
    int width = 0;
    int depth = 0;
    std::vector<float> heights; // above the centre [m]; infinite where the rock is not

    bool has(float height) const { return height > -1e30F && height < 1e30F; }
};

/// @param vertices relative to the rock's centre [m]
/// @param cell side of a cell [m]
void rasterise(std::span<const Vec3> vertices, std::span<const Mesh::Triangle> triangles,
               double cell, Side side, Footprint& out);

} // namespace scree::rocks
