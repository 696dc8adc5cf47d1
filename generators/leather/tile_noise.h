// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

#include <cstdint>
#include <vector>

namespace scree {

/// Gradient noise that repeats with the unit square (Perlin 2002, on a wrapped lattice), with
/// gradients of unit length in directions drawn for every lattice point. Values are scaled to a
/// standard deviation of about 1/3 and stay within [-1.5, 1.5]; the slope is continuous.
class TileNoise {
  public:
    /// `columns` and `rows`: lattice cells along u and v, at least 1. `stream` keeps noises of one
    /// seed apart.
    TileNoise(int columns, int rows, std::uint64_t seed, std::uint64_t stream);

    float operator()(const Vec2& uv) const;

  private:
    int columns_;
    int rows_;
    std::vector<Vec2f> gradients_;
};

/// Octaves of noise, each of twice the frequency and half the height of the one before.
class TileFractal {
  public:
    TileFractal(int columns, int rows, int octaves, std::uint64_t seed, std::uint64_t stream);

    float operator()(const Vec2& uv) const;

  private:
    std::vector<TileNoise> octaves_;
};

} // namespace scree
