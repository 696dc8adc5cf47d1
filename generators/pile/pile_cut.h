// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/bodies/placed_bodies.h"

namespace scree {

/// A plane in the target's frame; what lies on the side that the normal points to is left out of
/// the finished pile.
struct CutPlane {
    Imath::V3d point{0.0, 0.0, 0.0}; // [m]
    Imath::V3d normal{0.0, 0.0, 1.0};
};

/// The pile without the components whose largest inner balls have their centres beyond the plane.
PlacedBodies cut_open(const PlacedBodies& pile, const CutPlane& plane);

} // namespace scree
