// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedurals/solid/wood/wood_specs.h"

#include "procedurals/solid/solid_specs.h"
#include "procedurals/solid/wood/wood_presets.h"

namespace scree {

namespace {

ParamSpec preset_spec() {
    std::vector<std::string> names;
    for (const WoodPreset& preset : wood_presets())
        names.push_back(preset.name);
    return {.name = "preset",
            .type = ParamType::choice,
            .doc = "Timber with default parameters, which the other parameters override.",
            .fallback = std::string("oak"),
            .choices = names};
}

} // namespace

std::vector<ParamSpec> wood_specs() {
    return solid_specs({
        preset_spec(),
        preset_color("early", "Colour of early wood, which grows in spring."),
        preset_color("late", "Colour of late wood, which ends a year."),
        preset_number("rings", "Years in one `size`, in place of ring_thickness.", "", 0.01, 1e6),
        preset_number("ring_thickness", "Mean width of a year.", "m", 1e-6, 1e3),
        preset_number("ring_variation", "How far years' ends lie off evenness, in years.", "", 0,
                      0.45),
        preset_number("tint_variation", "How much paler the palest year's late wood is.", "", 0, 1),
        preset_number("turbulence",
                      "k: how far the fractal field pushes the rings, in 64ths of `size`.", "", 0,
                      1000),
        preset_number("stretch", "Of the fractal field along the trunk.", "", 0.01, 1000),
        {.name = "profile",
         .type = ParamType::choice,
         .doc = "Profile of a ring: early and late wood, or the paper's sine.",
         .optional = true,
         .choices = {"year", "sine"}},
        preset_number("early_share", "Share of a year that is early wood alone.", "", 0, 0.95),
        preset_number("late_share", "Share that is late wood alone.", "", 0, 0.95),
        preset_number("late_sharpness", "1: a year ends at once; 0: as slowly as may be.", "", 0,
                      1),
        preset_number("asymmetry", "Share by which years are wider on one side of the pith.", "", 0,
                      0.9),
        preset_number("wander", "How far the pith swings about its axis.", "m", 0, 10),
        preset_number("fibre", "Contrast of fine streaks along the grain.", "", 0, 1),
        preset_number("pores", "Share of places for vessels that have one.", "", 0, 1),
        preset_number("pore_size", "Mean diameter of a vessel.", "m", 1e-7, 1),
        preset_number("pore_length", "Length of a vessel.", "m", 1e-6, 10),
        preset_number("ring_porous", "1: vessels in early wood alone; 0: everywhere.", "", 0, 1),
        preset_color("pore", "Colour inside of vessels."),
        preset_number("rays", "Share of places for rays that have one.", "", 0, 1),
        preset_number("ray_height", "Height of a ray along the trunk.", "m", 1e-6, 10),
        preset_number("ray_width", "Width of a ray.", "m", 1e-7, 1),
        preset_color("ray", "Colour of rays."),
        number_spec("knots", "Branches per metre of trunk.", "1/m", 0, 0, 1000),
        number_spec("knot_size", "Growth of a branch's radius against the trunk's.", "", 0.12, 0.01,
                    0.9),
        {.name = "knot",
         .type = ParamType::color,
         .doc = "Colour of knots; darker and redder than the wood when not given.",
         .optional = true},
        preset_number("sapwood", "Radius from which the wood is sapwood; none unless given.", "m",
                      0, 1e3),
        number_spec("late_height", "How far late wood stands out, as on weathered boards.", "m", 0,
                    -1, 1),
        number_spec("pore_depth", "Depth of vessels that are cut open.", "m", 0, -1, 1),
        {.name = "iterations",
         .type = ParamType::integer,
         .doc = "Iterations of the inversion of the displacement; 0: first order.",
         .fallback = std::int64_t{0},
         .min = 0.0,
         .max = 16.0},
        preset_number("early_roughness", "Roughness of early wood; unless given, the material's.",
                      "", 0, 1),
        preset_number("late_roughness", "Roughness of late wood.", "", 0, 1),
    });
}

} // namespace scree
