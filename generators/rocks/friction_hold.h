// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generators/rocks/lowering_plane.h"

namespace scree::rocks {

/// Whether a rock that touches others at these places can rest there: whether forces within the
/// contacts' friction cones, of 35 degrees, add up to what bears its weight at the centre of mass
/// without turning it. The nearest such forces are found by coordinate descent; they are to come
/// within 3% of the weight.
/// @param reach of the rock, which makes torques comparable to forces [m]
bool can_rest(std::span<const Gap> contacts, double reach);

} // namespace scree::rocks
