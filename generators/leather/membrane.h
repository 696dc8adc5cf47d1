// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generators/leather/groove_network.h"

namespace scree {

/// How far each pixel is swollen: the membrane that solves u - L^2 (u_xx + u_yy) = 1 with u = 0 on
/// the grooves. Along a straight groove far from others u = 1 - exp(-distance / L), so that L is
/// the width of the shoulder; a cell narrower than some L becomes a dome without a flat top,
/// whatever its shape, and has no crease where a distance field would have one (Gurumoorthy &
/// Rangarajan 2009; Crane, Weischedel & Wardetzky 2013 use the same equation for smooth distances).
///
/// The grooves cut the raster's edges where the network says, so that they do not show its steps
/// (Shortley & Weller 1938). Over-relaxed Gauss-Seidel in red-black order, a fixed number of
/// sweeps: same bytes on any number of threads. `shoulder`: L [m]. Values in [0, 1), one per pixel.
std::vector<float> membrane(const GrooveNetwork& network, double shoulder, const Context& context);

} // namespace scree
