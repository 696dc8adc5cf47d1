// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/mesh/mesh.h"

#include <span>

namespace scree {

/// A right-handed metric screw thread about the y axis (ISO 68-1: flanks of 60 degrees, crest 1/8
/// and root 1/4 of the pitch wide) that runs out into circles at both ends.
struct Thread {
    double pitch = 0; // [m]
    double root_radius = 0;
    double crest_radius = 0; // less than root_radius for an internal thread
    double end_radius = 0;   // of the circles at both ends
    double bottom = 0;       // y of the circles [m]
    double top = 0;
    double fade = 0; // length over which the thread rises from an end [m]
};

/// The thread's surface, with a column of vertices at each of the rising `angles` in [0, 2 pi). It
/// is open at the two end circles, which equal level_ring(angles, end_radius, y). An external
/// thread faces outwards, an internal one inwards. UVs as by `loft`, without normals.
Mesh thread_surface(std::span<const double> angles, const Thread& thread);

/// Depth of the thread for a pitch [m]: 5/8 of the height of its fundamental triangle (ISO 68-1).
double thread_depth(double pitch);

/// The coarse pitch of ISO 261 for a nominal diameter [m], interpolated between the sizes.
double coarse_pitch(double diameter);

} // namespace scree
