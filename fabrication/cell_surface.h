// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace scree {

/// The corners of a cell are numbered by their coordinates: bit 0 is x, bit 1 y, bit 2 z. Edge
/// `4 axis + p` is parallel to the axis; the bits of p are its coordinates on the next two axes, in
/// cyclic order.
struct CellEdge {
    int lower; // corner
    int axis;
};
CellEdge cell_edge(int edge);

/// The triangles that separate the inside corners of a cell (the bits of `inside`) from the outside
/// ones, counter-clockwise seen from outside. A triangle is given by the three edges whose
/// crossings are its vertices.
///
/// These are tables of marching cubes (Lorensen & Cline 1987), generated such that the surface of a
/// lattice is a closed manifold. On an ambiguous face the two inside corners are always separated,
/// so that both cells agree. The resulting loops are triangulated without diagonals that lie in a
/// face, where the two cells could have the same one.
const std::vector<std::array<std::uint8_t, 3>>& cell_surface(unsigned inside);

} // namespace scree
