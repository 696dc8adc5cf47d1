// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "procedurals/solid/cells/grains_specs.h"

namespace scree {

/// Veins along the borders of cells.
struct CellVeinRecipe {
    Color color{1.0F, 1.0F, 1.0F};
    double size = 0.05;    // of a cell [m]
    double width = 0.5e-3; // [m]
    double share = 0.8;    // of the vein colour in a vein
};

/// A commercial polished breccia, with real dimensions.
struct BrecciaPreset {
    std::string name;
    GrainRecipe stones; // shares are of the whole volume
    Color cement{0.5F, 0.5F, 0.5F};
    Color band{0.5F, 0.5F, 0.5F};
    double band_width = 3e-3; // [m]
    double bands = 0;         // share of the band colour
    double cloudy = 0.08;
    std::vector<CellVeinRecipe> veins; // 0 to 2
    double turbulence = 2.5;
};

const std::vector<BrecciaPreset>& breccia_presets();

} // namespace scree
