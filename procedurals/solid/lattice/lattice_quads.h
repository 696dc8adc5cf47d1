// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "procedurals/solid/lattice/fractal_lattice.h"

#include <cstdint>
#include <span>

namespace scree {

/// A lattice's stored nodes laid out for many points: with every node stand three neighbours and
/// two of these as differences, so that one load of 16 bytes has all eight corners of a cell. Four
/// times the memory of 16-bit nodes; for baking. Thread-safe once made.
class LatticeQuads {
  public:
    /// Of all levels up to `level`, at most those stored: the field through a filter. The lattice
    /// must outlive it.
    LatticeQuads(const FractalLattice& lattice, int level);
    explicit LatticeQuads(const FractalLattice& lattice)
        : LatticeQuads(lattice, lattice.header().levels) {}

    /// The field of these levels at places in unit cubes, at most 2^15 of them from the first. The
    /// spans have one length. All vector paths give the same bits, at most error() from the scalar
    /// path, which is that of the lattice.
    void fluctuations(std::span<const float> x, std::span<const float> y, std::span<const float> z,
                      std::span<float> out) const;

    /// What 16 bits round where the lattice has floats or its neighbours differ by very much; and
    /// weights along y have 15 bits, which moves the value by at most the difference of two nodes
    /// times 2^-16.
    float error() const { return error_; }

    int level() const { return level_; }
    float step() const { return step_; }
    /// Node (x, y, z) has at 4 (x + (n + 1) (y + n z)), where n = 2^level: its value v, v(x, y + 1,
    /// z) - v, w = v(x, y, z + 1) and v(x, y + 1, z + 1) - w.
    const std::int16_t* quads() const { return quads_.get(); }

  private:
    float value_outside(const solid::Triple& place) const;

    const FractalLattice& lattice_;
    int level_;
    float step_; // of a number
    float error_;
    LargeArray<std::int16_t> quads_;
};

/// The same on the vector path in use, as if the lattice repeated.
void vector_fluctuations(const LatticeQuads& quads, std::span<const float> x,
                         std::span<const float> y, std::span<const float> z, std::span<float> out);

} // namespace scree
