// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace scree {

/// A cell's corners are numbered by their coordinates: bit 0 is x, bit 1 y, bit 2 z. Its edge
/// `4 axis + p` runs along the axis; the bits of p are its place along the following axis and the
/// one after that (x follows z).
struct CellEdge {
    int lower; // corner
    int axis;
};
CellEdge cell_edge(int edge);

/// The triangles, as edges whose crossings are their corners, that part the corners inside (a bit
/// each) from those outside, counter-clockwise seen from outside.
///
/// The tables of marching cubes (Lorensen & Cline 1987) made by rule so that the surface of a
/// lattice is a closed manifold: on a face, inside corners that share no edge are parted, so that
/// both cells at the face see the same; the loops that this makes are triangulated without
/// diagonals that lie in a face, where two cells could have the same one.
const std::vector<std::array<std::uint8_t, 3>>& cell_surface(unsigned inside);

} // namespace scree
