// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generators/leather/cell_layout.h"

#include <functional>

namespace scree {

/// The grooves between cells: the generalised Voronoi diagram of the cells' regions, on a square
/// raster of the torus, `resolution` pixels along each edge, row-major from (0, 0). Every point
/// belongs to the cell whose region is nearest, so that the gaps between the regions close.
struct GrooveNetwork {
    int resolution = 0;
    double pixel = 0;                 // edge of a pixel [m]
    std::vector<std::uint32_t> owner; // the cell
    std::vector<float> distance;      // to the groove: half of how much farther the second nearest
                                      // region is than the nearest one [m]
    std::vector<float> junction;      // half of how much farther the third nearest is [m]
    std::vector<float> along;         // where the pixel lies along its cell's long axis, in units
                                      // of the cell's radius, about -1 to 1

    std::size_t index(int x, int y) const {
        return std::size_t(y) * std::size_t(resolution) + std::size_t(x);
    }
};

/// Moves a point of the torus before the cells are looked up; must be periodic.
using Warp = std::function<Vec2(const Vec2& point)>;

/// The groove network of the layout, at least three cells, seen through `warp` (null: as it is).
/// Distances to the regions are exact up to the rounding of floats; blocks of pixels share the list
/// of cells that can be among their three nearest. Same bytes on any number of threads.
GrooveNetwork groove_network(const CellLayout& layout, int resolution, const Warp& warp,
                             const Context& context);

} // namespace scree
