// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

#include <string>
#include <vector>

namespace scree {

/// One system of veins. Lengths are shares of the texture's `size`.
struct MarbleVeins {
    Color color{0.0F, 0.0F, 0.0F};
    int count = 4;           // per period, which is `size`
    double width = 0.01;     // mean
    double diffusion = 0.03; // length over which a vein decays to 1/e
    double contrast = 1;     // share of the colour in the middle of a vein
    double turbulence = 16;  // k, in cells of the paper's lattice of 64
    double tilt = 0;         // angle of the normal to the axis [rad]
};

/// A commercial marble.
struct MarblePreset {
    std::string name;
    Color filler{1.0F, 1.0F, 1.0F};
    Color cloud{1.0F, 1.0F, 1.0F};
    double cloudiness = 0;
    std::vector<MarbleVeins> veins; // 1 to 4
};

const std::vector<MarblePreset>& marble_presets();

} // namespace scree
