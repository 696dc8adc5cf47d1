// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generators/fibres/fibre_shape.h"

#include <vector>

namespace scree::fibres {

/// A chain as a uniform cubic B-spline that passes through every third vertex and the last.
struct Spline {
    std::vector<Vec3> points; // control points: three more than pieces [m]
    std::vector<float> radii; // of each [m]
    float excess = 0;         // how far a vertex of the chain is off the curve, at most [m]
};

/// Pieces of the spline of a chain of so many segments: 11 of 32.
constexpr std::uint32_t spline_pieces(std::uint32_t segments) { return (segments + 2) / 3; }

/// The spline of one fibre.
Spline spline_of(std::span<const Vec3> chain, const FibreShape& shape);

} // namespace scree::fibres
