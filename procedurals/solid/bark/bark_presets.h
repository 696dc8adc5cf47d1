// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "procedurals/solid/cells/cells_shapes.h"

namespace scree {

/// The bark of a grown tree, with real dimensions.
struct BarkPreset {
    std::string name;
    Color color[2]{{0.3F, 0.3F, 0.3F}, {0.4F, 0.4F, 0.4F}}; // flakes have colours between these
    Color fissure{0.0F, 0.0F, 0.0F};
    std::vector<CreaseRecipe> fissures; // 0 to 3, the widest plates first
    CreaseRecipe flakes{};              // `depth` is the height of the highest flake
    double flake_edge = 0;
    BedRecipe bands{};
    SpotRecipe pores{};
    SpotRecipe scars{};
    Color pore{0.0F, 0.0F, 0.0F};
    Color scar{0.0F, 0.0F, 0.0F};
    double pore_height = 0; // [m]; negative: recessed
    double scar_height = 0;
    Color lichen{0.0F, 0.0F, 0.0F};
    double lichen_share = 0;
    double fibre = 0;
    double relief = 0; // [m]
    double relief_size = 0.03;
    double relief_stretch = 1;
    double turbulence = 3;
    double roughness = 0.85;
};

const std::vector<BarkPreset>& bark_presets();

} // namespace scree
