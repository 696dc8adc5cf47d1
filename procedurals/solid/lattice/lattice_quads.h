// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "procedurals/solid/lattice/fractal_lattice.h"

#include <cstdint>
#include <span>

namespace scree {

/// A lattice's stored nodes, laid out for evaluation at many points: every node is stored together
/// with three neighbours, two of them as differences, so that one load of 16 bytes fetches all
/// eight corners of a cell. Takes four times the memory of 16-bit nodes; used for baking.
/// Immutable, so thread-safe.
class LatticeQuads {
  public:
    /// Holds the levels up to `level`, which must be stored: the filtered field. The lattice must
    /// outlive this.
    LatticeQuads(const FractalLattice& lattice, int level);
    explicit LatticeQuads(const FractalLattice& lattice)
        : LatticeQuads(lattice, lattice.header().levels) {}

    /// The field of these levels at points in unit cubes, whose coordinates are at most 2^15. The
    /// spans have equal lengths. All vector paths give the same bits; they differ by at most
    /// error() from the scalar path, which is exact for the lattice.
    void fluctuations(std::span<const float> x, std::span<const float> y, std::span<const float> z,
                      std::span<float> out) const;

    /// The largest error: that of rounding to 16 bits (for a lattice of floats or with very large
    /// differences), and that of the weights along y, which have 15 bits: at most 2^-16 times the
    /// difference of two nodes.
    float error() const { return error_; }

    int level() const { return level_; }
    float step() const { return step_; }
    /// The record of node (x, y, z) begins at 4 (x + (n + 1) (y + n z)), where n = 2^level, and
    /// holds v = v(x, y, z), v(x, y + 1, z) - v, w = v(x, y, z + 1) and v(x, y + 1, z + 1) - w.
    const std::int16_t* quads() const { return quads_.get(); }

  private:
    float value_outside(const solid::Triple& place) const;

    const FractalLattice& lattice_;
    int level_;
    float step_; // unit of the integers
    float error_;
    LargeArray<std::int16_t> quads_;
};

/// The same with the active vector path, treating the lattice as periodic.
void vector_fluctuations(const LatticeQuads& quads, std::span<const float> x,
                         std::span<const float> y, std::span<const float> z, std::span<float> out);

} // namespace scree
