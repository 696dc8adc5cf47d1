// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/bodies/mass_properties.h"

namespace scree {

/// A body that can be moved.
struct MovingBody {
    const Body* body = nullptr;
    const MassProperties* mass = nullptr;
    Pose pose;
};

/// Moves and turns two bodies, according to their masses and inertias, until their deepest contact
/// is `allowed` [m] deep (position-based dynamics of rigid bodies: Mueller et al. 2020, eq. 2 to 9,
/// without compliance). Returns how deep they were [m], or `allowed` if they were no deeper.
double push_apart(MovingBody& a, MovingBody& b, double allowed);

} // namespace scree
