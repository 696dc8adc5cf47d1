// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

#include <array>
#include <cstdint>
#include <span>

namespace scree::rocks {

/// A place on a rock's underside and how far it is above what is below it.
struct Gap {
    // Where the line along the contact's normal passes the height of the rock's centre of mass,
    // relative to that: when the rock turns, the gap grows as that of a place there would over
    // level ground [m].
    double x = 0;
    double z = 0;
    double height = 0;        // [m]
    WideVec3 arm{0, 0, 0};    // where it is itself, likewise [m]
    WideVec3 normal{0, 1, 0}; // of the contact, of length 1, out of what is below
    std::uint32_t below = 0;  // the number of the rock that is; HeightMap::no_rock for the ground
};

/// height + slope_x x + slope_z z.
struct LoweringPlane {
    double height = 0;
    double slope_x = 0;
    double slope_z = 0;
    bool held = false; // three gaps hold it; otherwise it is as steep as it may be
};

/// The plane that is nowhere above the gaps and highest at the centre of mass: lowered by it, the
/// rock rests on three legs around its centre of mass, but for the second order of the turn. It is
/// found among planes of a slope of about `most_slope` or less by a dual simplex: three legs that
/// enclose the centre of mass, of which one is replaced by the gap that is farthest below their
/// plane, until none is below. The first legs are no gaps but stand `reach` [m] away.
LoweringPlane lowering_plane(std::span<const Gap> gaps, double reach, double most_slope);

} // namespace scree::rocks
