// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedurals/solid/leather/leather.h"

#include "procedurals/solid/leather/leather_as_cpp.h"
#include "procedurals/solid/leather/leather_presets.h"
#include "procedurals/solid/leather/leather_source.h"
#include "procedurals/solid/solid_procedural.h"

namespace scree {

namespace {

using solid::Leather;

std::shared_ptr<const Procedural> make_leather(const Params& params) {
    const LeatherPreset& preset = preset_named(solid_leather_presets(), params);
    const double natural = preset.creases.front().size * preset_scale(params);
    const double scale = preset_scale(params) * number_or(params, "grain", natural) / natural;
    const double depth = preset.creases.front().depth * scale;
    const double deep = scale * number_or(params, "depth", depth) / depth;
    Leather leather{};
    leather.warp = make_warp(params, number_or(params, "turbulence", preset.turbulence), 0);
    for (std::size_t i = 0; i < preset.creases.size(); ++i) {
        leather.creases[i] =
            make_creases(params, static_cast<unsigned>(i), preset.creases[i], scale);
        leather.depth[i] = as_float(preset.creases[i].depth * deep);
        leather.dye[i] = as_float(preset.creases[i].dye * params.number("contrast"));
    }
    SpotRecipe pores = preset.pores;
    pores.share = number_or(params, "pores", pores.share);
    leather.pores = make_spots(params, 0, pores, scale);
    leather.pore_depth = as_float(preset.pore_depth * deep);
    leather.pore_dye = as_float(std::min(1.0, preset.pore_dye * params.number("contrast")));
    leather.hewn = make_hewn(params, params.number("relief"), 12 * natural);
    leather.color = as_triple(color_or(params, "color", preset.color));
    leather.crease = as_triple(color_or(params, "crease", preset.crease));
    leather.pore = as_triple(color_or(params, "pore", preset.pore));
    leather.stain = as_float(number_or(params, "stain", preset.stain));
    const double roughness = number_or(params, "roughness", preset.roughness);
    leather.roughness = as_float(roughness);
    leather.crease_roughness = as_float(std::min(1.0, roughness + 0.25)); // not polished by wear
    leather.filtered = params.flag("filtered") ? 1 : 0;
    static const std::string text = shapes_program({leather_source});
    return std::make_shared<SolidProcedural<Leather, solid::leather_at>>(
        make_lattice(params), leather, SolidKernel{text.c_str(), "Leather", "leather_at"},
        params.flag("scale_with_object"));
}

std::vector<ParamSpec> leather_specs() {
    return solid_specs({
        preset_choice(solid_leather_presets(),
                      "A leather whose grain to start from; what else is given changes it."),
        preset_color("color", "Of the skin."),
        preset_color("crease", "Colour between the hills of the grain."),
        preset_color("pore", "Colour of pores, or of knobs."),
        preset_number("grain", "Mean width of the grain's hills; all else goes with it.", "m", 1e-6,
                      1e4),
        preset_number("depth", "Of the creases between two hills; all else goes with it.", "m", 0,
                      1),
        preset_number("pores", "Share of places for a pore, or a knob, that have one.", "", 0, 1),
        {.name = "contrast",
         .type = ParamType::number,
         .doc = "Factor of the share of the crease and pore colours in creases and pores.",
         .fallback = 1.0,
         .min = 0.0,
         .max = 1.2},
        preset_number("stain", "Of brightness by the fractal field.", "", 0, 1),
        turbulence_spec("How far the fractal field pushes the grain"),
        preset_number("roughness", "Of the hills' tops; creases are duller.", "", 0, 1),
        {.name = "relief",
         .type = ParamType::number,
         .doc = "Height of additional bumps per unit of the fractal field.",
         .unit = "m",
         .fallback = 0.0,
         .min = 0.0,
         .max = 1.0},
    });
}

} // namespace

Plugin<MakeProcedural> solid_leather_plugin() {
    return {"leather",
            "Leather's grain as a solid: hills between soft creases, pores and knobs, bent and "
            "stained by a fractal field, with bumps, filtered over the pixel.",
            leather_specs(), make_leather};
}

} // namespace scree
