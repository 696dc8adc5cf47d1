// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedurals/solid/stone/stone.h"

#include "procedurals/solid/cells/grains_source.h"
#include "procedurals/solid/solid_procedural.h"
#include "procedurals/solid/stone/stone_as_cpp.h"
#include "procedurals/solid/stone/stone_presets.h"
#include "procedurals/solid/stone/stone_source.h"

namespace scree {

namespace {

using solid::Stone;

void set_beds(Stone& stone, const Params& params, const StonePreset& preset) {
    const SolidFrame frame = solid_frame(params);
    stone.axis = as_triple(frame.axis);
    stone.side = as_triple(frame.right);
    stone.start = frame.axis.dot(frame.origin);
    stone.cross = as_float(preset.cross);
    const double natural = preset.beds.front().thickness * preset_scale(params);
    const double scale = preset_scale(params) * number_or(params, "thickness", natural) / natural;
    for (std::size_t i = 0; i < preset.beds.size(); ++i) {
        BedRecipe bed = preset.beds[i];
        if (i == 0)
            bed.color = color_or(params, "bed", bed.color);
        stone.beds[i] = make_beds(params, static_cast<unsigned>(i), bed, scale);
        stone.bed_color[i] = as_triple(bed.color);
        stone.bed_share[i] = as_float(std::min(1.0, bed.contrast * params.number("contrast")));
        stone.bed_height[i] = as_float(bed.height * scale);
    }
}

void set_shells(Stone& stone, const Params& params, const StonePreset& preset,
                const solid::Lattice& lattice) {
    GrainRecipe shells = preset.shells;
    for (Mineral& mineral : shells.minerals)
        mineral.size *= preset_scale(params);
    if (params.has("shells")) {
        shells.minerals = minerals_of(params.list("shells"), 5e-3 * preset_scale(params));
        if (shells.outlines.empty())
            shells.outlines = {{0.12, 0.42}};
        while (shells.outlines.size() < GRAINS_MAX_LAYERS)
            shells.outlines.push_back(shells.outlines.back());
    }
    shells.clusters = 0;
    shells.roughness = double(stone.roughness);
    stone.grains = make_grains(params, "shells", shells, lattice);
}

std::shared_ptr<const Procedural> make_stone(const Params& params) {
    const StonePreset& preset = preset_named(stone_presets(), params);
    const double scale = preset_scale(params);
    const auto lattice = make_lattice(params);
    Stone stone{};
    stone.warp =
        make_warp(params, number_or(params, "turbulence", preset.turbulence), 0, preset.flatness);
    stone.color = as_triple(color_or(params, "color", preset.color));
    stone.roughness = as_float(number_or(params, "roughness", preset.roughness));
    set_beds(stone, params, preset);
    set_shells(stone, params, preset, lattice->header());
    stone.speckle = make_cells(params, 5, number_or(params, "sand", preset.sand * scale));
    stone.speckled = as_float(number_or(params, "sandy", preset.sandy));
    stone.cloudy = as_float(number_or(params, "cloudy", preset.cloudy));
    for (std::size_t i = 0; i < preset.holes.size(); ++i) {
        SpotRecipe holes = preset.holes[i];
        holes.share = std::min(1.0, holes.share * params.number("holes"));
        stone.holes[i] = make_spots(params, static_cast<unsigned>(i), holes, scale);
    }
    stone.hole_beds = as_float(preset.hole_beds);
    stone.hole_depth = as_float(number_or(params, "hole_depth", preset.hole_depth * scale));
    stone.hole = as_triple(color_or(params, "hole", preset.hole));
    stone.hole_share = 0.85F;
    stone.hewn = make_hewn(params, number_or(params, "relief", preset.relief * scale),
                           preset.relief_size * scale, preset.relief_stretch);
    stone.filtered = params.flag("filtered") ? 1 : 0;
    static const std::string text = shapes_program({grains_source, stone_source});
    return std::make_shared<SolidProcedural<Stone, solid::stone_at>>(
        lattice, stone, SolidKernel{text.c_str(), "Stone", "stone_at"},
        params.flag("scale_with_object"));
}

std::vector<ParamSpec> stone_specs() {
    const auto factor = [](const char* name, const char* doc, double max) {
        return ParamSpec{.name = name,
                         .type = ParamType::number,
                         .doc = doc,
                         .fallback = 1.0,
                         .min = 0.0,
                         .max = max};
    };
    return solid_specs({
        preset_choice(stone_presets(),
                      "A stone whose beds to start from; what else is given changes it."),
        preset_color("color", "Of the stone itself."),
        preset_color("bed", "Colour of the thickest beds."),
        preset_number("thickness", "Mean of the thickest beds; the others go with them.", "m", 1e-6,
                      1e4),
        factor("contrast", "Factor of the share that beds have of their colours.", 10),
        turbulence_spec("How far the fractal field pushes the beds"),
        preset_number("sand", "Mean width of a grain of sand.", "m", 1e-6, 1e4),
        preset_number("sandy", "Of brightness from one grain of sand to the next.", "", 0, 1),
        preset_number("cloudy", "Of brightness by the fractal field.", "", 0, 1),
        minerals_spec("shells", "Shells or pebbles in place of the preset's, of at most six sizes; "
                                "a share is of the stone."),
        factor("holes", "Factor of the number of holes.", 10),
        preset_number("hole_depth", "Of a hole's bump.", "m", 0, 1),
        preset_color("hole", "Colour in holes."),
        preset_number("relief", "Height of a rough-hewn surface per unit of the fractal field.",
                      "m", 0, 1),
        preset_number("roughness", "Of the stone.", "", 0, 1),
    });
}

} // namespace

Plugin<MakeProcedural> stone_plugin() {
    return {"stone",
            "Sandstone, limestone, travertine, slate: beds that a fractal field bends, with sand, "
            "shells and holes, filtered over the pixel.",
            stone_specs(), make_stone};
}

} // namespace scree
