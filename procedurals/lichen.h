// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

namespace scree {

/// Crusts of lichen: balls in space, of three sizes, cut by the surface that they grow on, with
/// ragged borders.
class Lichen {
  public:
    /// The most of a surface that can be asked for.
    static constexpr double most_cover = 0.8;

    /// @param cover share of a fully exposed surface, up to most_cover
    /// @param size of the largest, across [m]
    Lichen(double cover, double size, std::uint32_t seed);

    struct Seen {
        float cover = 0;              // share of the filter
        float shade = 1;              // by which the colour is multiplied: rims are paler
        float hue = 0;                // of the crusts, in [0, 1], each its own
        Vec3 slope{0.0F, 0.0F, 0.0F}; // of their thickness
    };

    /// @param width of the filter [m]
    /// @param exposure in [0, 1]: how much of their full size they reach
    Seen at(const Vec3& position, float width, float exposure) const;

  private:
    Seen layer(const WideVec3& position, double width, double exposure, double spacing,
               std::uint32_t seed) const;

    double size_;
    double chance_ = 0;      // that one of the places of a cell has a crust
    double layer_cover_ = 0; // of one of the three sizes
    std::uint32_t seed_;
};

} // namespace scree
