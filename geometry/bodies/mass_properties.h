// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/bodies/pile_component.h"

namespace scree {

/// What a component weighs, of even density 1, in its own frame.
struct MassProperties {
    double mass = 0;             // [m^3]
    Vec3 centre;                 // of mass [m]
    Imath::M33d inverse_inertia; // about that centre [m^-5]
};

/// Of what a closed mesh encloses, or of a sheet.
MassProperties mass_properties(const PileComponent& component);

} // namespace scree
