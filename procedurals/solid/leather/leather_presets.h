// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "procedurals/solid/cells/cells_shapes.h"

namespace scree {

/// A kind of leather, with real dimensions.
struct LeatherPreset {
    std::string name;
    Color color{0.0F, 0.0F, 0.0F};
    Color crease{0.0F, 0.0F, 0.0F};
    std::vector<CreaseRecipe> creases; // 1 to 3, the main grain first
    SpotRecipe pores{};
    double pore_depth = 0; // [m]; negative: knobs
    Color pore{0.0F, 0.0F, 0.0F};
    double pore_dye = 0;
    double stain = 0.06;
    double roughness = 0.4;
    double turbulence = 1;
};

const std::vector<LeatherPreset>& solid_leather_presets();

} // namespace scree
