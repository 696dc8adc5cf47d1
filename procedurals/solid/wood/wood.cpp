// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedurals/solid/wood/wood.h"

#include "core/random.h"
#include "procedurals/solid/solid_procedural.h"
#include "procedurals/solid/solid_specs.h"
#include "procedurals/solid/wood/wood_as_cpp.h"
#include "procedurals/solid/wood/wood_presets.h"
#include "procedurals/solid/wood/wood_source.h"
#include "procedurals/solid/wood/wood_specs.h"

#include <algorithm>

namespace scree {

namespace {

using solid::Wood;

const WoodPreset& preset_of(const Params& params) {
    const auto& presets = wood_presets();
    return *std::find_if(presets.begin(), presets.end(), [&](const WoodPreset& preset) {
        return preset.name == params.text("preset");
    });
}

/// The factor that changes the wood's mean colour to `wanted`.
Color factor_to(const Color& wanted, const Color& early, const Color& late) {
    const Color mean = early * 0.6F + late * 0.4F;
    return {wanted.x / mean.x, wanted.y / mean.y, wanted.z / mean.z};
}

void set_rings(Wood& wood, const Params& params, const WoodPreset& preset) {
    const auto number = [&](const char* name, double otherwise) {
        return as_float(number_or(params, name, otherwise));
    };
    wood.ring = number("ring_thickness", preset.ring);
    if (params.has("rings")) {
        if (params.has("ring_thickness"))
            throw params.error("rings", "rings and ring_thickness say the same: give one");
        wood.ring = as_float(params.number("size") / params.number("rings"));
    }
    wood.displacement =
        as_float(number_or(params, "turbulence", preset.turbulence) * cell_length(params));
    wood.ring_variation = number("ring_variation", preset.ring_variation);
    wood.tint_variation = number("tint_variation", preset.tint_variation);
    wood.asymmetry = number("asymmetry", preset.asymmetry);
    wood.wander = number("wander", preset.wander);
    wood.sine = preset.sine ? 1 : 0;
    if (params.has("profile"))
        wood.sine = params.text("profile") == "sine" ? 1 : 0;
    const double early = number_or(params, "early_share", preset.early_share);
    const double late = number_or(params, "late_share", preset.late_share);
    if (!(early + late < 0.96))
        throw params.error("early_share",
                           "early and late wood together leave no room for what is between: "
                           "their shares must add up to less than 0.96");
    const double end =
        1 - 0.5 * (1 - number_or(params, "late_sharpness", preset.late_sharpness)) * (1 - early);
    wood.late_end = as_float(std::min(end, 0.99));
    wood.early_end = as_float(early);
    wood.late_begin = as_float(std::max(early + 0.02, double(wood.late_end) - late));
}

void set_cells(Wood& wood, const Params& params, const WoodPreset& preset) {
    const auto number = [&](const char* name, double otherwise) {
        return as_float(number_or(params, name, otherwise));
    };
    // Vessels are at most as wide as half a cell, so that each reaches adjacent cells only.
    const float pore = number("pore_size", preset.pore_size);
    wood.pore_share = number("pores", preset.pores);
    wood.pore_radius = 0.32F;
    wood.pore_cell = pore / (2 * wood.pore_radius * 0.8F); // the mean radius is 0.8 of the largest
    wood.pore_length = number("pore_length", preset.pore_length);
    wood.ring_porous = number("ring_porous", preset.ring_porous);
    wood.ray_share = number("rays", preset.rays);
    wood.ray_width = number("ray_width", preset.ray_width);
    wood.ray_height = number("ray_height", preset.ray_height);
    wood.ray_cell = wood.ray_width * 5;
}

std::shared_ptr<const Procedural> make_wood(const Params& params) {
    const WoodPreset& preset = preset_of(params);
    const SolidFrame frame = solid_frame(params);
    Random random(static_cast<std::uint64_t>(params.integer("seed")), Purpose::solid_ring);
    const auto as_color = [](const Color& c) { return solid::Triple{c.x, c.y, c.z}; };
    Wood wood{};
    wood.key = random.bits();
    const double turn = random.uniform(0, 2 * pi);
    const double ellipse = preset.sine ? 0 : 0.04;
    const Vec3 right = frame.right * static_cast<float>(std::cos(turn)) +
                       frame.up * static_cast<float>(std::sin(turn));
    wood.right = as_triple(right * static_cast<float>(1 + ellipse));
    wood.up = as_triple(frame.axis.cross(right) * static_cast<float>(1 - ellipse));
    wood.axis = as_triple(frame.axis);
    wood.origin = as_triple(frame.origin);
    const double stretch = number_or(params, "stretch", preset.stretch);
    wood.placement = placement(params, frame, 0, 1, stretch);
    wood.fibre_placement = placement(params, frame, 0, 0.11, 45);
    wood.filtered = params.flag("filtered") ? 1 : 0;
    wood.iterations = static_cast<int>(params.integer("iterations"));
    set_rings(wood, params, preset);
    set_cells(wood, params, preset);
    wood.wander_rate = as_float(2 * pi / 0.6); // a wavelength of 0.6 m
    wood.knot_spacing = params.number("knots") > 0 ? as_float(1 / params.number("knots")) : 0.0F;
    wood.knot_growth = as_float(params.number("knot_size"));
    wood.fibre = as_float(number_or(params, "fibre", preset.fibre));
    wood.sapwood = params.has("sapwood") ? as_float(params.number("sapwood")) : 0.0F;
    wood.late_height = as_float(params.number("late_height"));
    wood.pore_depth = as_float(params.number("pore_depth"));
    wood.early_roughness = wood.late_roughness = ShadingSample::unset;
    if (params.has("early_roughness") != params.has("late_roughness"))
        throw params.error(params.has("early_roughness") ? "early_roughness" : "late_roughness",
                           "early_roughness and late_roughness go together: give both or neither");
    if (params.has("early_roughness")) {
        wood.early_roughness = as_float(params.number("early_roughness"));
        wood.late_roughness = as_float(params.number("late_roughness"));
    }
    const Color early = color_or(params, "early", preset.early);
    const Color late = color_or(params, "late", preset.late);
    wood.early = as_color(early);
    wood.late = as_color(late);
    wood.pore = as_color(color_or(params, "pore", preset.pore));
    wood.ray = as_color(color_or(params, "ray", preset.ray));
    // Sapwood is lighter and less coloured than heartwood, knots are darker and redder.
    wood.sap = {1.25F, 1.4F, 1.6F};
    wood.knot = {0.5F, 0.38F, 0.28F};
    if (params.has("knot"))
        wood.knot = as_color(factor_to(reflectance(params, "knot"), early, late));
    return std::make_shared<SolidProcedural<Wood, solid::wood_at>>(
        make_lattice(params), wood, SolidKernel{wood_source, "Wood", "wood_at"},
        params.flag("scale_with_object"));
}

} // namespace

Plugin<MakeProcedural> wood_plugin() {
    return {"wood",
            "Wood: annual rings around a pith, displaced by a fractal field (Okada et al. 1987), "
            "with knots, vessels and rays, filtered over the pixel.",
            wood_specs(), make_wood};
}

} // namespace scree
