// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "procedurals/solid/cells/cells_shapes.h"
#include "procedurals/solid/cells/grains_specs.h"

namespace scree {

/// A sediment, or slate, as builders know it; true lengths.
struct StonePreset {
    std::string name;
    Color color{0.0F, 0.0F, 0.0F};
    std::vector<BedRecipe> beds;   // 1 to 3, thickest first
    double cross = 0;              // slope of the finer beds within the thickest
    double sand = 0.5e-3;          // [m]
    double sandy = 0;              // of brightness from grain to grain
    double cloudy = 0.03;          // of brightness by the fractal field
    GrainRecipe shells{};          // and pebbles
    std::vector<SpotRecipe> holes; // 0 to 2
    double hole_beds = 0;          // 1: only in beds that have the first's colour
    double hole_depth = 0;
    Color hole{0.0F, 0.0F, 0.0F};
    double relief = 0; // [m]
    double relief_size = 0.03;
    double relief_stretch = 1;
    double turbulence = 2;
    double flatness = 1; // the field that pushes beds is so much shorter across them
    double roughness = 0.7;
};

const std::vector<StonePreset>& stone_presets();

} // namespace scree
