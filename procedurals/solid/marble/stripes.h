// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "procedurals/solid/lattice/lattice_quads.h"
#include "procedurals/solid/marble/vein_table.h"

#include <span>

namespace scree {

/// The paper's marble to first order: the veins at z - displacement D (eq. 9). Lengths are in unit
/// cubes.
void marble_values(const LatticeQuads& quads, const VeinTable& veins, float displacement,
                   std::span<const float> x, std::span<const float> y, std::span<const float> z,
                   std::span<float> out);

/// The paper's wood: sin(2 pi rings (r - displacement D)), where r is the distance from the axis
/// through (x, y) parallel to z (eqs. 10 and 11). All vector paths give the same bits. They differ
/// from the scalar path by at most 1e-5, plus the effect of the difference in D.
struct PlainWood {
    float x = 0, y = 0;
    float rings = 0; // per unit cube
    float displacement = 0;
};
void wood_values(const LatticeQuads& quads, const PlainWood& wood, std::span<const float> x,
                 std::span<const float> y, std::span<const float> z, std::span<float> out);

/// The same for given fluctuations D.
void ring_values(const PlainWood& wood, std::span<const float> x, std::span<const float> y,
                 std::span<const float> d, std::span<float> out);

} // namespace scree
