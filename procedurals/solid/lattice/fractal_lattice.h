// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "procedurals/solid/lattice/fluctuation_as_cpp.h"
#include "procedurals/solid/lattice/large_array.h"

#include <span>

namespace scree {

/// Parameters of a lattice.
struct LatticeSettings {
    std::uint64_t seed = 1;
    int levels = 7;          // stored: (2^levels + 1)^3 nodes; 0 to 8
    int detail = 6;          // further levels, evaluated where a filter resolves them
    double decay = 0.8;      // beta: L_n = exp(-(n - 1) beta)
    bool repeats = true;     // periodic in unit cubes; otherwise every unit cube is different
    bool sixteen_bit = true; // nodes have two bytes instead of four
};

/// A 3-D random fractal lattice (Okada, Yokoi, Toriwaki & Hori 1987): a field over space whose
/// period (or first cube) is the unit cube. The random number of a node is a hash of its level and
/// its coordinates on that level. So the nodes may be computed in any order, levels that are not
/// stored can be evaluated on demand, and lattices with different numbers of levels agree at their
/// common nodes. Levels beyond the seventh (or beyond the last stored one) come from a small
/// periodic tile of nodes, stored after the others; they are too fine for the repetition to be
/// visible. Immutable, so thread-safe.
class FractalLattice {
  public:
    explicit FractalLattice(const LatticeSettings& settings);

    /// The field filtered with a `width` in unit cubes; 0: all levels. The rounding error of 16-bit
    /// nodes is at most half of `header().step`.
    solid::Fluctuation at(const solid::Triple& place, float width = 0) const {
        return solid::fluctuation(&header_, nodes16_.get(), nodes32_.get(), place, width);
    }

    /// A stored node; 0 <= x, y, z <= side().
    float node(int x, int y, int z) const;
    int side() const { return 1 << header_.levels; } // cells along an edge

    /// The data for lattice.cl; one of the two arrays of nodes is empty. x varies fastest, z
    /// slowest; the nodes of the tile follow those of the lattice.
    const solid::Lattice& header() const { return header_; }
    std::span<const std::int16_t> nodes16() const {
        return {nodes16_.get(), nodes16_ ? count_ : 0};
    }
    std::span<const float> nodes32() const { return {nodes32_.get(), nodes32_ ? count_ : 0}; }

  private:
    solid::Lattice header_{};
    std::size_t count_; // of all nodes, including those of the tile
    LargeArray<std::int16_t> nodes16_;
    LargeArray<float> nodes32_;
};

/// The exact mean over space of (T_n / L_n)^2, where T_n is the contribution of level n.
double mean_square_of_level();

} // namespace scree
