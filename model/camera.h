// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

namespace scree {

/// A thin-lens perspective camera; with aperture 0 a pinhole.
struct Camera {
    WideVec3 from{0, 1, 3}; // eye [m]
    WideVec3 at{0, 0, 0};   // looked at [m]
    Vec3 up{0.0F, 1.0F, 0.0F};
    float fov = 0.61F;  // full vertical angle of view [rad]
    float aperture = 0; // diameter of the lens [m]
    float focus = 0;    // distance of the focal plane along the view direction [m]; 0: through `at`
};

} // namespace scree
