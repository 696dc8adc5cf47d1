// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/bodies/mass_properties.h"

namespace scree {

/// A component that may be moved.
struct Body {
    const PileComponent* component = nullptr;
    const MassProperties* mass = nullptr;
    Pose pose;
};

/// Moves and turns two bodies, by mass and lever arm, until their deepest contact either way is
/// `allowed` [m] deep (position-based dynamics of rigid bodies: Mueller et al. 2020, eq. 2 to 9,
/// without compliance). Returns how deep they were [m], or `allowed` where they were no deeper.
double push_apart(Body& a, Body& b, double allowed);

} // namespace scree
