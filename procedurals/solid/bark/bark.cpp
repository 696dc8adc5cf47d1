// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedurals/solid/bark/bark.h"

#include "procedurals/solid/bark/bark_as_cpp.h"
#include "procedurals/solid/bark/bark_presets.h"
#include "procedurals/solid/bark/bark_source.h"
#include "procedurals/solid/solid_procedural.h"

namespace scree {

namespace {

using solid::Bark;

std::shared_ptr<const Procedural> make_bark(const Params& params) {
    const BarkPreset& preset = preset_named(bark_presets(), params);
    const SolidFrame frame = solid_frame(params);
    const double natural =
        preset_scale(params) * std::max(preset.flakes.size, preset.fissures.front().size);
    const double scale = preset_scale(params) * number_or(params, "plate", natural) / natural;
    const double deep = scale * params.number("depth");
    Bark bark{};
    bark.warp = make_warp(params, number_or(params, "turbulence", preset.turbulence), 0);
    bark.axis = as_triple(frame.axis);
    bark.start = frame.axis.dot(frame.origin);
    bark.color[0] = as_triple(color_or(params, "dark", preset.color[0]));
    bark.color[1] = as_triple(color_or(params, "light", preset.color[1]));
    bark.fissure = as_triple(color_or(params, "fissure", preset.fissure));
    for (std::size_t i = 0; i < preset.fissures.size(); ++i) {
        bark.fissures[i] =
            make_creases(params, 1 + static_cast<unsigned>(i), preset.fissures[i], scale);
        bark.depth[i] = as_float(preset.fissures[i].depth * deep);
        bark.dark[i] = as_float(preset.fissures[i].dye);
    }
    bark.flakes = make_creases(params, 0, preset.flakes, scale);
    bark.flake_height = as_float(preset.flakes.depth * deep);
    bark.flake_edge = as_float(preset.flake_edge);
    bark.bands = make_beds(params, 0, preset.bands, scale);
    bark.band = as_triple(color_or(params, "band", preset.bands.color));
    bark.band_share = as_float(preset.bands.contrast);
    SpotRecipe pores = preset.pores;
    pores.share = number_or(params, "pores", pores.share);
    SpotRecipe scars = preset.scars;
    scars.share = number_or(params, "scars", scars.share);
    bark.pores = make_spots(params, 0, pores, scale);
    bark.scars = make_spots(params, 1, scars, scale);
    bark.pore = as_triple(color_or(params, "pore", preset.pore));
    bark.scar = as_triple(color_or(params, "scar", preset.scar));
    bark.pore_height = as_float(preset.pore_height * deep);
    bark.scar_height = as_float(preset.scar_height * deep);
    bark.lichen = as_triple(color_or(params, "lichen_color", preset.lichen));
    bark.lichen_share = as_float(number_or(params, "lichen", preset.lichen_share));
    bark.fibre = as_float(preset.fibre);
    bark.hewn =
        make_hewn(params, preset.relief * deep, preset.relief_size * scale, preset.relief_stretch);
    bark.roughness = as_float(number_or(params, "roughness", preset.roughness));
    bark.filtered = params.flag("filtered") ? 1 : 0;
    static const std::string text = shapes_program({bark_source});
    return std::make_shared<SolidProcedural<Bark, solid::bark_at>>(
        make_lattice(params), bark, SolidKernel{text.c_str(), "Bark", "bark_at"},
        params.flag("scale_with_object"));
}

std::vector<ParamSpec> bark_specs() {
    return solid_specs({
        preset_choice(bark_presets(),
                      "A tree whose bark to start from; what else is given changes it."),
        preset_color("dark", "Colour of the deepest flakes."),
        preset_color("light", "Colour of the highest flakes."),
        preset_color("fissure", "Colour in fissures."),
        preset_color("band", "Colour of bands across the trunk."),
        preset_color("pore", "Colour of pores (lenticels)."),
        preset_color("scar", "Colour of scars."),
        preset_number("plate", "Mean width of the largest plates; all else goes with it.", "m",
                      1e-6, 1e4),
        {.name = "depth",
         .type = ParamType::number,
         .doc = "Factor of the height of all bumps.",
         .fallback = 1.0,
         .min = 0.0,
         .max = 10.0},
        preset_number("pores", "Share of places for a pore that have one.", "", 0, 1),
        preset_number("scars", "Share of places for a scar that have one.", "", 0, 1),
        preset_color("lichen_color", "Of lichen and algae."),
        preset_number("lichen", "Share of their colour where the fractal field is highest.", "", 0,
                      1),
        turbulence_spec("How far the fractal field pushes fissures and flakes"),
        preset_number("roughness", "Of the bark.", "", 0, 1),
    });
}

} // namespace

Plugin<MakeProcedural> bark_plugin() {
    return {"bark",
            "Bark: plates between fissures along the axis, flakes, pores, bands and scars, bent by "
            "a fractal field, with bumps, filtered over the pixel.",
            bark_specs(), make_bark};
}

} // namespace scree
