// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "procedurals/solid/lattice/cell_vector.h"

#include <cstddef>

namespace scree {

/// Nodes of a level and all before it.
inline std::size_t node_count(int level) {
    const std::size_t nodes = (std::size_t(1) << level) + 1;
    return nodes * nodes * nodes;
}

/// Arrays of nodes go on by so many, which hold nothing: vectors may reach beyond the last one.
constexpr std::size_t node_padding = 256;

/// Makes the nodes of a header's stored levels, x fastest, on the path in use (see vector_path.h);
/// all paths find the same bits.
void make_nodes(const solid::Lattice& header, float* nodes);

/// The same, rounded to multiples of `header.step`, which it chooses. Only the levels before the
/// last are ever held as floats.
void make_nodes(solid::Lattice& header, std::int16_t* nodes);

/// The unit of 16-bit nodes when `largest` is the greatest size of a node of any level but the
/// last: what the last can add is bounded, as no variate is beyond 5.42 and the centre of a cube
/// leans on those of its faces, and these on those of its edges.
inline float step_of_nodes(const solid::Lattice& header, float largest) {
    constexpr float most = 3 * 5.42F;
    const float last = header.levels > 0 ? most * header.spread[header.levels] : 0;
    return std::fmax(largest + last, 1e-30F) / 32767;
}

/// Level 0: the lattice's eight corners.
inline float corner_node(const solid::Lattice& header, std::uint32_t x, std::uint32_t y,
                         std::uint32_t z) {
    return header.repeats != 0
               ? 0
               : header.spread[0] * solid::node_normal(header.key_a, header.key_b, 0, x, y, z);
}

/// The reference: node by node, as the paper says it.
void make_nodes_plainly(const solid::Lattice& header, float* nodes);
void make_nodes_plainly(solid::Lattice& header, std::int16_t* nodes);

} // namespace scree
