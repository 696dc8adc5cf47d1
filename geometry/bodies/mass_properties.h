// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/bodies/body.h"

namespace scree {

/// Mass and inertia of a body of density 1, in its own frame.
struct MassProperties {
    double mass = 0;             // the volume [m^3]
    Vec3 centre;                 // of mass [m]
    Imath::M33d inverse_inertia; // about the centre of mass [m^-5]
};

/// Those of the volume that a closed mesh encloses, or of a sheet as an infinitely thin surface
/// with the mass of its thickness.
MassProperties mass_properties(const Body& body);

} // namespace scree
