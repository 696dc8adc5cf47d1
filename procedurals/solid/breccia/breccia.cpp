// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedurals/solid/breccia/breccia.h"

#include "core/random.h"
#include "procedurals/solid/breccia/breccia_as_cpp.h"
#include "procedurals/solid/breccia/breccia_presets.h"
#include "procedurals/solid/breccia/breccia_source.h"
#include "procedurals/solid/cells/grains_source.h"
#include "procedurals/solid/solid_procedural.h"

namespace scree {

namespace {

using solid::Breccia;

GrainRecipe stones_of(const Params& params, const BrecciaPreset& preset) {
    GrainRecipe recipe = preset.stones;
    const double largest = recipe.minerals.front().size;
    const double size = number_or(params, "fragment", largest * preset_scale(params));
    for (Mineral& stone : recipe.minerals)
        stone.size *= size / largest;
    if (params.has("fragments")) {
        recipe.minerals = minerals_of(params.list("fragments"), size);
        while (recipe.outlines.size() < GRAINS_MAX_LAYERS)
            recipe.outlines.push_back(recipe.outlines.back());
    }
    if (params.has("gap"))
        for (std::size_t i = 0; i < recipe.outlines.size(); ++i)
            recipe.outlines[i].gap = params.number("gap") / 2 / size;
    recipe.roughness = number_or(params, "roughness", recipe.roughness);
    return recipe;
}

/// The share of space that the veins cover.
float measured_share(const solid::CellVeins& veins) {
    constexpr int points = 20000;
    Random random(veins.cells.key, Purpose::solid_cell, 3000);
    int inside = 0;
    for (int i = 0; i < points; ++i) {
        solid::CellView view{};
        view.place = {float(random.uniform(0, 1000)), float(random.uniform(0, 1000)),
                      float(random.uniform(0, 1000))};
        view.key = veins.cells.key;
        solid::Seeds seeds;
        solid::gather_seeds(view, veins.cells.jitter, CELLS_REACH, veins.half_width, 0, &seeds);
        solid::Triple inwards;
        inside += solid::border_distance(&seeds, 1e3F, &inwards) < veins.half_width ? 1 : 0;
    }
    return float(inside) / points;
}

std::shared_ptr<const Procedural> make_breccia(const Params& params) {
    const BrecciaPreset& preset = preset_named(breccia_presets(), params);
    const double scale = preset_scale(params);
    const auto lattice = make_lattice(params);
    const GrainRecipe stones = stones_of(params, preset);
    Breccia breccia{};
    breccia.warp = make_warp(params, number_or(params, "turbulence", preset.turbulence), 0);
    breccia.grains = make_grains(params, "fragments", stones, lattice->header());
    breccia.cement = as_triple(color_or(params, "cement", preset.cement));
    breccia.band = as_triple(color_or(params, "band", preset.band));
    const double band_width = number_or(params, "band_width", preset.band_width * scale);
    double largest = 0;
    for (const Mineral& stone : stones.minerals)
        largest = std::max(largest, stone.size);
    breccia.band_rate = as_float(largest / band_width);
    breccia.bands = as_float(number_or(params, "bands", preset.bands));
    breccia.cloudy = as_float(number_or(params, "cloudy", preset.cloudy));
    const bool veined = number_or(params, "vein_width", 1) > 0;
    for (std::size_t i = 0; veined && i < preset.veins.size(); ++i) {
        const CellVeinRecipe& recipe = preset.veins[i];
        solid::CellVeins& veins = breccia.veins[i];
        const double width =
            i == 0 ? number_or(params, "vein_width", recipe.width * scale) : recipe.width * scale;
        veins.cells = make_cells(params, 90 + static_cast<unsigned>(i), recipe.size * scale);
        veins.half_width = as_float(width / 2 / (recipe.size * scale));
        veins.share = as_float(recipe.share);
        veins.color = as_triple(i == 0 ? color_or(params, "vein", recipe.color) : recipe.color);
        veins.mean = measured_share(veins);
    }
    breccia.relief = as_float(params.number("relief"));
    breccia.edge = 0.03F;
    breccia.hewn = make_hewn(params, 0.3 * params.number("relief"), largest);
    breccia.roughness = as_float(stones.roughness);
    breccia.cement_roughness = as_float(std::min(1.0, 1.3 * stones.roughness));
    breccia.filtered = params.flag("filtered") ? 1 : 0;
    static const std::string text = cells_program({grains_source, breccia_source});
    return std::make_shared<SolidProcedural<Breccia, solid::breccia_at>>(
        lattice, breccia, SolidKernel{text.c_str(), "Breccia", "breccia_at"},
        params.flag("scale_with_object"));
}

std::vector<ParamSpec> breccia_specs() {
    return solid_specs({
        preset_choice(breccia_presets(),
                      "A breccia whose stones to start from; what else is given changes it."),
        preset_number("fragment", "Mean width of the largest stones; the others go with it.", "m",
                      1e-6, 1e4),
        minerals_spec("fragments",
                      "One to twelve kinds of stones in place of the preset's; larger "
                      "ones lie over smaller ones, of at most six sizes; a share is of "
                      "all, and what is left is cement."),
        preset_number("gap", "Least width of the cement between two stones.", "m", 0, 1e4),
        preset_color("cement", "Colour between the stones."),
        preset_color("band", "Colour of bands in the cement, about the largest stones."),
        preset_number("bands", "Share of that colour in a band.", "", 0, 1),
        preset_number("band_width", "From one band to the next.", "m", 1e-6, 1e4),
        preset_number("cloudy", "Of the cement's brightness by the fractal field.", "", 0, 1),
        preset_color("vein", "Colour of the widest veins."),
        preset_number("vein_width", "Width of the widest veins; 0: there are no veins.", "m", 0,
                      1e4),
        turbulence_spec("How far the fractal field pushes the stones' borders"),
        preset_number("roughness", "Of the stones; cement is duller.", "", 0, 1),
        {.name = "relief",
         .type = ParamType::number,
         .doc = "Height of the largest stones above the cement; 0: polished.",
         .unit = "m",
         .fallback = 0.0,
         .min = 0.0,
         .max = 1.0},
    });
}

} // namespace

Plugin<MakeProcedural> breccia_plugin() {
    return {"breccia",
            "Breccia: broken stones of several sizes in a banded cement, with veins, whose borders "
            "a fractal field pushes about, filtered over the pixel.",
            breccia_specs(), make_breccia};
}

} // namespace scree
