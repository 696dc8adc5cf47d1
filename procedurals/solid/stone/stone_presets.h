// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "procedurals/solid/cells/cells_shapes.h"
#include "procedurals/solid/cells/grains_specs.h"

namespace scree {

/// A sedimentary stone or slate used in building, with real dimensions.
struct StonePreset {
    std::string name;
    Color color{0.0F, 0.0F, 0.0F};
    std::vector<BedRecipe> beds;   // 1 to 3, thickest first
    double cross = 0;              // slope of the finer beds within the thickest
    double sand = 0.5e-3;          // size of sand grains [m]
    double sandy = 0;              // variation of brightness between sand grains
    double cloudy = 0.03;          // change of brightness per unit of the fractal field
    GrainRecipe shells{};          // and pebbles
    std::vector<SpotRecipe> holes; // 0 to 2
    double hole_beds = 0;          // 1: only in full beds of the first kind
    double hole_depth = 0;
    Color hole{0.0F, 0.0F, 0.0F};
    double relief = 0; // [m]
    double relief_size = 0.03;
    double relief_stretch = 1;
    double turbulence = 2;
    double flatness = 1; // factor by which the warping field is compressed across the beds
    double roughness = 0.7;
};

const std::vector<StonePreset>& stone_presets();

} // namespace scree
