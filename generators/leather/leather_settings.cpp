// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/leather/leather_settings.h"

#include <fmt/format.h>

#include <algorithm>

namespace scree {

namespace {

LeatherSettings fine_calf() {
    LeatherSettings s;
    s.name = "fine_calf";
    s.cell = 0.62e-3;
    s.cell_range = {0.55, 1.5};
    s.elongation = 1.25;
    s.irregularity = 0.8;
    s.meander = 0.22;
    s.depth = 38e-6;
    s.roundness = 0.6;
    s.fullness = 0.25;
    s.height_variation = 0.35;
    s.groove_width = 0.1e-3;
    s.groove_depth = 20e-6;
    s.groove_variation = 0.85;
    s.minor_cell = 0.42;
    s.minor_depth = 6e-6;
    s.wrinkle_depth = 55e-6;
    s.wrinkle_spacing = 4.5e-3;
    s.pore_depth = 50e-6;
    s.pore_width = 0.07e-3;
    s.pore_density = 0.35;
    s.roughness = 1.5e-6;
    s.undulation = 70e-6;
    s.undulation_cells = 18;
    return s;
}

LeatherSettings coarse_grain() {
    LeatherSettings s;
    s.name = "coarse_grain";
    s.cell = 2.8e-3;
    s.cell_range = {0.4, 1.5};
    s.elongation = 1.35;
    s.direction_spread = radians(60);
    s.irregularity = 0.9;
    s.meander = 0.3;
    s.depth = 0.36e-3;
    s.roundness = 0.68;
    s.fullness = 0.4;
    s.height_variation = 0.25;
    s.groove_width = 0.3e-3;
    s.groove_depth = 0.16e-3;
    s.groove_variation = 0.7;
    s.minor_cell = 0.3;
    s.minor_depth = 45e-6;
    s.wrinkle_depth = 30e-6;
    s.wrinkle_spacing = 2.2e-3;
    s.pore_depth = 70e-6;
    s.pore_width = 0.07e-3;
    s.pore_density = 3;
    s.roughness = 4e-6;
    s.undulation = 0.12e-3;
    s.undulation_cells = 5;
    return s;
}

LeatherSettings reptile() {
    LeatherSettings s;
    s.name = "reptile";
    s.cell = 5e-3;
    s.cell_range = {0.85, 1.25};
    s.gap_cell = 0.33;
    s.elongation = 1.4;
    s.direction_spread = radians(14);
    s.irregularity = 0.45;
    s.meander = 0.06;
    s.depth = 0.55e-3;
    s.roundness = 0.45;
    s.fullness = 0.6;
    s.height_variation = 0.12;
    s.tilt = 0.3;
    s.overhang = 0.3;
    s.groove_width = 0.24e-3;
    s.groove_depth = 0.22e-3;
    s.groove_variation = 0.1;
    s.minor_cell = 0.16;
    s.minor_depth = 16e-6;
    s.wrinkle_depth = 22e-6;
    s.wrinkle_spacing = 2.5e-3;
    s.roughness = 3e-6;
    s.undulation = 0.15e-3;
    s.undulation_cells = 4;
    return s;
}

LeatherSettings pebbled() {
    LeatherSettings s;
    s.name = "pebbled";
    s.cell = 1.8e-3;
    s.cell_range = {0.6, 1.2};
    s.elongation = 1.08;
    s.irregularity = 0.35;
    s.meander = 0.05;
    s.depth = 0.5e-3;
    s.roundness = 1;
    s.fullness = 0.35;
    s.height_variation = 0.12;
    s.groove_width = 0.36e-3;
    s.groove_depth = 0.08e-3;
    s.minor_cell = 0.3;
    s.minor_depth = 5e-6;
    s.pore_depth = 25e-6;
    s.pore_width = 0.05e-3;
    s.pore_density = 0.8;
    s.roughness = 4e-6;
    s.undulation = 0.06e-3;
    s.undulation_cells = 6;
    return s;
}

/// One number of the settings as a parameter.
struct Number {
    const char* name;
    double LeatherSettings::*member;
    const char* unit;
    double min;
    double max;
    bool above_min;
    const char* doc;
};

constexpr Number numbers[] = {
    {"cell", &LeatherSettings::cell, "m", 0, 10, true,
     "Width of a cell: the diameter of a disk of the same area."},
    {"gap_cell", &LeatherSettings::gap_cell, "", 0, 1, false,
     "Size of the small cells that fill the gaps between the others, as a share of cell; 0: none."},
    {"elongation", &LeatherSettings::elongation, "", 1, 6, false, "Length by width of the cells."},
    {"direction_spread", &LeatherSettings::direction_spread, "deg", 0, 180, false,
     "How far cells turn away from direction, either way; 180: lying any way."},
    {"irregularity", &LeatherSettings::irregularity, "", 0, 1, false,
     "How uneven the cells' outlines are."},
    {"meander", &LeatherSettings::meander, "", 0, 0.5, false,
     "How far grooves wander off their straight course, as a share of cell."},
    {"depth", &LeatherSettings::depth, "m", 0, 1, false,
     "Height of the cristae, the cells' tops, above the base plane."},
    {"roundness", &LeatherSettings::roundness, "", 0, 1, false,
     "Shape of the cristae: 0 flat tops with narrow shoulders, 1 domes."},
    {"fullness", &LeatherSettings::fullness, "", 0, 1, false,
     "Flanks of the cristae: 0 a parabola's soft ones, 1 an ellipse's steep ones."},
    {"height_variation", &LeatherSettings::height_variation, "", 0, 1, false,
     "How much the cells' heights differ, as a share."},
    {"tilt", &LeatherSettings::tilt, "", -1, 1, false,
     "How much higher a cell's front end lies, as a share of depth, as on scales."},
    {"overhang", &LeatherSettings::overhang, "", 0, 0.35, false,
     "How far the shoulders of the cristae lean over the grooves, as a share of groove_width; "
     "above 0 the map is a vector displacement."},
    {"groove_width", &LeatherSettings::groove_width, "m", 0, 1, true,
     "Width of the sulci, the grooves, at 1/e of their depth."},
    {"groove_depth", &LeatherSettings::groove_depth, "m", 0, 1, false,
     "Depth of the sulci below the base plane."},
    {"groove_variation", &LeatherSettings::groove_variation, "", 0, 1, false,
     "How much shallower some grooves are than others; 1: some fade out altogether."},
    {"minor_cell", &LeatherSettings::minor_cell, "", 0, 0.6, false,
     "Spacing of the minor grooves that subdivide the cells, as a share of cell; 0: none."},
    {"minor_depth", &LeatherSettings::minor_depth, "m", 0, 1, false, "Depth of the minor grooves."},
    {"wrinkle_depth", &LeatherSettings::wrinkle_depth, "m", 0, 1, false,
     "Depth of the soft wrinkles that run across direction."},
    {"wrinkle_spacing", &LeatherSettings::wrinkle_spacing, "m", 0, 10, true,
     "Distance between wrinkles."},
    {"pore_depth", &LeatherSettings::pore_depth, "m", 0, 1, false, "Depth of the hair pores."},
    {"pore_width", &LeatherSettings::pore_width, "m", 0, 1, true, "Width of the hair pores."},
    {"pore_density", &LeatherSettings::pore_density, "", 0, 100, false,
     "Number of pores in a square with sides of one cell; most lie where grooves meet."},
    {"roughness", &LeatherSettings::roughness, "m", 0, 1, false,
     "Height of the finest grain, a few pixels wide."},
    {"undulation", &LeatherSettings::undulation, "m", 0, 1, false,
     "Height of the waves that are longer than the cells."},
    {"undulation_cells", &LeatherSettings::undulation_cells, "", 1, 100, false,
     "Length of those waves, in cells."},
};

} // namespace

const std::vector<LeatherSettings>& leather_presets() {
    static const std::vector<LeatherSettings> presets{fine_calf(), coarse_grain(), reptile(),
                                                      pebbled()};
    return presets;
}

std::vector<ParamSpec> leather_setting_specs() {
    std::vector<std::string> names;
    for (const LeatherSettings& preset : leather_presets())
        names.push_back(preset.name);
    std::vector<ParamSpec> specs{
        {.name = "preset",
         .type = ParamType::choice,
         .doc = "A kind of leather: it sets whatever below is not given.",
         .fallback = std::string("coarse_grain"),
         .choices = names},
        {.name = "cell_range",
         .type = ParamType::range,
         .doc = "Sizes of the cells, as factors of cell.",
         .optional = true,
         .min = 0.05,
         .max = 4.0},
    };
    for (const Number& number : numbers)
        specs.push_back({.name = number.name,
                         .type = ParamType::number,
                         .doc = number.doc,
                         .unit = number.unit,
                         .optional = true,
                         .min = number.min,
                         .max = number.max,
                         .above_min = number.above_min});
    return specs;
}

LeatherSettings settings_from(const Params& params) {
    LeatherSettings settings;
    for (const LeatherSettings& preset : leather_presets())
        if (preset.name == params.text("preset"))
            settings = preset;
    for (const Number& number : numbers)
        if (params.has(number.name))
            settings.*number.member = params.number(number.name);
    if (params.has("cell_range"))
        settings.cell_range = params.range("cell_range");
    if (settings.groove_width > settings.cell)
        throw params.error(params.has("groove_width") ? "groove_width" : "cell",
                           fmt::format("grooves {:.4g} mm wide leave nothing of cells of {:.4g} mm",
                                       settings.groove_width * 1e3, settings.cell * 1e3));
    return settings;
}

} // namespace scree
