// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedurals/solid/granite/granite.h"

#include "procedurals/solid/cells/grains_source.h"
#include "procedurals/solid/granite/granite_as_cpp.h"
#include "procedurals/solid/granite/granite_presets.h"
#include "procedurals/solid/granite/granite_source.h"
#include "procedurals/solid/solid_procedural.h"

namespace scree {

namespace {

using solid::Granite;

/// The minerals of the preset or those given by the user, scaled to this texture.
GrainRecipe recipe_of(const Params& params, const GranitePreset& preset) {
    GrainRecipe recipe = preset.grains;
    double largest = 0;
    for (const Mineral& mineral : recipe.minerals)
        largest = std::max(largest, mineral.size);
    const double grain = number_or(params, "grain", largest * preset_scale(params));
    for (Mineral& mineral : recipe.minerals)
        mineral.size *= grain / largest;
    if (params.has("minerals")) {
        recipe.minerals = minerals_of(params.list("minerals"), grain);
        recipe.outlines.clear();
    }
    recipe.clusters = number_or(params, "clusters", recipe.clusters);
    recipe.roughness = number_or(params, "roughness", recipe.roughness);
    return recipe;
}

std::shared_ptr<const Procedural> make_granite(const Params& params) {
    const GranitePreset& preset = preset_named(granite_presets(), params);
    const auto lattice = make_lattice(params);
    const GrainRecipe recipe = recipe_of(params, preset);
    Granite granite{};
    granite.warp = make_warp(params, number_or(params, "turbulence", preset.turbulence), 0);
    granite.hewn = make_hewn(params, params.number("relief"), 4 * recipe.minerals.front().size);
    granite.filtered = params.flag("filtered") ? 1 : 0;
    granite.grains = make_grains(params, "minerals", recipe, lattice->header());
    static const std::string text = cells_program({grains_source, granite_source});
    return std::make_shared<SolidProcedural<Granite, solid::granite_at>>(
        lattice, granite, SolidKernel{text.c_str(), "Granite", "granite_at"},
        params.flag("scale_with_object"));
}

std::vector<ParamSpec> granite_specs() {
    return solid_specs({
        preset_choice(granite_presets(),
                      "A granite whose minerals to start from; what else is given changes it."),
        preset_number("grain", "Mean width of the largest grains; the others go with it.", "m",
                      1e-6, 1e4),
        minerals_spec("minerals", "One to twelve minerals in place of the preset's; larger grains "
                                  "lie over smaller ones, of at most six sizes."),
        preset_number("clusters",
                      "How much grains of a kind crowd where the fractal field is "
                      "high or low.",
                      "", 0, 0.95),
        turbulence_spec("How far the fractal field pushes the grains' borders"),
        preset_number("roughness", "Of the light minerals; mica is duller.", "", 0, 1),
        {.name = "relief",
         .type = ParamType::number,
         .doc = "Height of a rough-hewn surface per unit of the fractal field; 0: polished.",
         .unit = "m",
         .fallback = 0.0,
         .min = 0.0,
         .max = 1.0},
    });
}

} // namespace

Plugin<MakeProcedural> granite_plugin() {
    return {"granite",
            "Granite: crystals of several minerals and sizes in cells (Worley 1996) whose borders "
            "a fractal field pushes about, filtered over the pixel.",
            granite_specs(), make_granite};
}

} // namespace scree
