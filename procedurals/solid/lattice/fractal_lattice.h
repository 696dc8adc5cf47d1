// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "procedurals/solid/lattice/cell_vector.h"
#include "procedurals/solid/lattice/large_array.h"

#include <span>

namespace scree {

/// What a lattice is made of.
struct LatticeSettings {
    std::uint64_t seed = 1;
    int levels = 7;          // stored: (2^levels + 1)^3 nodes; 0 to 8
    int detail = 6;          // more levels, evaluated where a filter asks for them
    double decay = 0.8;      // beta: L_n = exp(-(n - 1) beta)
    bool repeats = true;     // the unit cubes are all alike and fit; otherwise each is another
    bool sixteen_bit = true; // nodes of two bytes in place of four
};

/// A 3-D random fractal lattice (Okada, Yokoi, Toriwaki & Hori 1987): a field over space whose
/// period, or first cube, is the unit cube. Every node's random number is a hash of its level and
/// coordinates there, so that the order of making does not matter, levels that are not stored can
/// be had on demand, and a lattice of more levels agrees with one of fewer at their common nodes.
/// Levels beyond the seventh, or beyond those stored, draw on few numbers that repeat, too fine to
/// be seen to, and come from a small tile of nodes behind the others. Thread-safe once made.
class FractalLattice {
  public:
    explicit FractalLattice(const LatticeSettings& settings);

    /// The field through a filter `width` wide, in unit cubes; 0: all levels. Nodes of 16 bits are
    /// off by at most half of `header().step`.
    solid::Fluctuation at(const solid::Triple& place, float width = 0) const {
        return solid::fluctuation(&header_, nodes16_.get(), nodes32_.get(), place, width);
    }

    /// A stored node; 0 <= x, y, z <= side().
    float node(int x, int y, int z) const;
    int side() const { return 1 << header_.levels; } // cells along an edge

    /// What the .cl text takes; one of the two arrays is empty. Order: x fastest, z slowest; the
    /// tile's nodes follow the lattice's.
    const solid::Lattice& header() const { return header_; }
    std::span<const std::int16_t> nodes16() const {
        return {nodes16_.get(), nodes16_ ? count_ : 0};
    }
    std::span<const float> nodes32() const { return {nodes32_.get(), nodes32_ ? count_ : 0}; }

  private:
    solid::Lattice header_{};
    std::size_t count_; // of nodes, with the tile's
    LargeArray<std::int16_t> nodes16_;
    LargeArray<float> nodes32_;
};

/// Mean over space of (T_n / L_n)^2, where T_n is what level n adds: exact.
double mean_square_of_level();

} // namespace scree
