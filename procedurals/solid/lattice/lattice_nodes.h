// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "procedurals/solid/lattice/fluctuation_as_cpp.h"

#include <cstddef>

namespace scree {

/// The number of nodes of a level and all previous ones.
inline std::size_t node_count(int level) {
    const std::size_t nodes = (std::size_t(1) << level) + 1;
    return nodes * nodes * nodes;
}

/// Unused elements at the end of node arrays, since vector code may access elements beyond the last
/// node.
constexpr std::size_t node_padding = 256;

/// Computes the nodes of a header's stored levels, x fastest, with the active vector path (see
/// vector_path.h). All paths give the same bits.
void make_nodes(const solid::Lattice& header, float* nodes);

/// The same, rounded to multiples of `header.step`, which is chosen here. Only the levels before
/// the last need memory for floats.
void make_nodes(solid::Lattice& header, std::int16_t* nodes);

/// The unit of 16-bit nodes, where `largest` is the largest absolute value of a node before the
/// last level. The last level adds at most 3 * 5.42 L_n: variates are at most 5.42, and a cube's
/// centre depends on those of its faces, which depend on those of their edges.
inline float step_of_nodes(const solid::Lattice& header, float largest) {
    constexpr float max_variates = 3 * 5.42F;
    const float last = header.levels > 0 ? max_variates * header.amplitude[header.levels] : 0;
    return std::fmax(largest + last, 1e-30F) / 32767;
}

/// A node of level 0: one of the lattice's eight corners.
inline float corner_node(const solid::Lattice& header, std::uint32_t x, std::uint32_t y,
                         std::uint32_t z) {
    return header.repeats != 0
               ? 0
               : header.amplitude[0] * solid::node_normal(header.key_a, header.key_b, 0, x, y, z);
}

/// The reference implementation: node by node, as in the paper.
void make_nodes_plainly(const solid::Lattice& header, float* nodes);
void make_nodes_plainly(solid::Lattice& header, std::int16_t* nodes);

} // namespace scree
