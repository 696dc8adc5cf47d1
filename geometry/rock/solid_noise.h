// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

#include <cstdint>

namespace scree {

/// From a at t = 0 to b at t = 1: std::lerp, without its guarantees at the ends, is ten times
/// faster.
inline double mix(double a, double b, double t) { return a + t * (b - a); }

/// 32 well-mixed bits for a cell of the integer lattice.
std::uint32_t lattice_hash(int x, int y, int z, std::uint32_t seed);

/// Gradient noise in space (Perlin 2002): about [-1, 1], root mean square about 0.27, wavelength
/// about 1, slope and curvature continuous.
double gradient_noise(const WideVec3& p, std::uint32_t seed);

/// Three of these that have nothing to do with each other.
WideVec3 vector_noise(const WideVec3& p, std::uint32_t seed);

/// Noise of broken faces: each cell of a random Voronoi diagram is a slanted plane of its own, and
/// neighbours are blended over a narrow seam. About [-1, 1], cells about 1 wide.
double faceted_noise(const WideVec3& p, std::uint32_t seed);

} // namespace scree
