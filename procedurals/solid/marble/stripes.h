// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "procedurals/solid/lattice/lattice_quads.h"
#include "procedurals/solid/marble/vein_table.h"

#include <span>

namespace scree {

/// The paper's marble, to first order: the veins at z - push D (eq. 9); all in unit cubes.
void marble_values(const LatticeQuads& quads, const VeinTable& veins, float push,
                   std::span<const float> x, std::span<const float> y, std::span<const float> z,
                   std::span<float> out);

/// Its wood: sin(2 pi rings (r - push D)), r the distance from the axis through (x, y) along z
/// (eqs. 10 and 11). The same bits on all vector paths, within 1e-5 of the scalar path's beside
/// what D differs.
struct PlainWood {
    float x = 0, y = 0;
    float rings = 0; // per unit cube
    float push = 0;
};
void wood_values(const LatticeQuads& quads, const PlainWood& wood, std::span<const float> x,
                 std::span<const float> y, std::span<const float> z, std::span<float> out);

/// The same where the fluctuations D are at hand.
void ring_values(const PlainWood& wood, std::span<const float> x, std::span<const float> y,
                 std::span<const float> d, std::span<float> out);

} // namespace scree
