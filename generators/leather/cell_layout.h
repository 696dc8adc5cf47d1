// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/context.h"
#include "generators/leather/leather_settings.h"
#include "geometry/figures/collision_shape.h"

namespace scree {

/// One cell of the leather: which outline, and where.
struct Cell {
    std::uint32_t shape = 0;
    FigurePose pose;
};

/// Cells on a square torus [0, size) x [0, size), which do not overlap, not even across its border.
struct CellLayout {
    double size = 0; // edge of the torus [m]
    std::vector<CollisionShape> shapes;
    std::vector<Cell> cells;

    double fill() const; // share of the torus that the cells cover
};

/// How cells are placed.
struct CellKind {
    double width = 0; // of a disk of the same area, at scale 1 [m]
    Range scale{1, 1};
    double elongation = 1; // length by width
    double direction = 0;  // [rad]
    double direction_spread = pi;
    double irregularity = 0.5;
};

/// An irregular rounded polygon with the area of a disk of diameter 1, longer along x: between
/// five and eight corners at uneven angles and distances, cut twice (Chaikin 1974).
Region cell_outline(double elongation, double irregularity, std::uint64_t seed,
                    std::uint64_t index);

/// Fills the torus with cells of one kind after the other, the large ones of a kind first, so that
/// small ones find the gaps between them (dart throwing, Sakurai & Miyata 2014, section 3.2, in
/// steps of size). `stream` keeps layouts of one seed apart. No cell's width exceeds a quarter of
/// the torus. Throws Cancelled.
CellLayout place_cells(double size, const std::vector<CellKind>& kinds, std::uint64_t seed,
                       std::uint64_t stream, const Context& context);

} // namespace scree
