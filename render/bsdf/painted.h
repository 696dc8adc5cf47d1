// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/procedural.h"

namespace scree {

/// What a material's paint says of a hit.
struct Painted {
    Color color{0.0F, 0.0F, 0.0F};
    float roughness = ShadingSample::unset; // perceptual; unset: the material's own
    bool bent = false;                      // `normal` takes the place of the shading normal
    Vec3 normal{0.0F, 0.0F, 0.0F};          // unit, on the outer side of the geometric normal
};

} // namespace scree
