// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/table.h"

#include "model/fibre_table.h"
#include "model/table_tools.h"

namespace scree {

namespace {

ParamSpec roughness_spec(double fallback) {
    return {.name = "roughness",
            .type = ParamType::number,
            .doc = "Perceptual roughness; its square is the GGX alpha.",
            .fallback = fallback,
            .min = 0.0,
            .max = 1.0};
}

ParamSpec ior_spec() {
    return {.name = "ior",
            .type = ParamType::number,
            .doc = "Index of refraction relative to air.",
            .fallback = 1.5,
            .min = least_ior,
            .max = largest_ior};
}

Plugin<MakeMaterial> matte_plugin() {
    return {"matte",
            "A perfectly diffuse surface (Lambert 1760).",
            {paint_spec(Color(0.5F, 0.5F, 0.5F), "Diffuse reflectance."), palette_spec()},
            [](const Params& params) -> Material { return Matte{make_paint(params)}; }};
}

Plugin<MakeMaterial> plastic_plugin() {
    return {"plastic",
            "A diffuse base under a clear coat, for toys, varnish and polished stone.",
            {paint_spec(Color(0.5F, 0.5F, 0.5F), "Diffuse reflectance of the base."),
             palette_spec(), roughness_spec(0.3), ior_spec()},
            [](const Params& params) -> Material {
                return Plastic{make_paint(params), float_number(params, "roughness"),
                               float_number(params, "ior")};
            }};
}

// Reflectance at normal incidence in linear Rec. 709: silver to iron from Lagarde, "Feeding a
// physically based shading model" (2011); brass from physicallybased.info (2022).
struct MetalPreset {
    const char* name;
    Color reflectance;
};
const MetalPreset metal_presets[] = {
    {"gold", {1.000F, 0.766F, 0.336F}},   {"copper", {0.955F, 0.637F, 0.538F}},
    {"silver", {0.972F, 0.960F, 0.915F}}, {"aluminium", {0.913F, 0.921F, 0.925F}},
    {"iron", {0.560F, 0.570F, 0.580F}},   {"brass", {0.910F, 0.778F, 0.423F}},
};

Plugin<MakeMaterial> metal_plugin() {
    std::vector<std::string> names;
    for (const MetalPreset& preset : metal_presets)
        names.emplace_back(preset.name);
    ParamSpec color =
        paint_spec({}, "Reflectance at normal incidence; replaces that of the preset when given.");
    color.fallback = {};
    color.optional = true;
    return {"metal",
            "A conductor with a GGX surface.",
            {{.name = "preset",
              .type = ParamType::choice,
              .doc = "A metal of known reflectance.",
              .fallback = std::string("aluminium"),
              .choices = names},
             color,
             palette_spec(),
             roughness_spec(0.2)},
            [](const Params& params) -> Material {
                Metal metal;
                metal.roughness = float_number(params, "roughness");
                for (const MetalPreset& preset : metal_presets)
                    if (params.text("preset") == preset.name)
                        metal.paint.texture = {preset.reflectance, nullptr};
                if (params.has("color"))
                    metal.paint = make_paint(params);
                else if (params.has("palette")) {
                    Params with_color = params;
                    with_color.set("color", metal.paint.texture.constant);
                    metal.paint = make_paint(with_color);
                }
                return metal;
            }};
}

Plugin<MakeMaterial> glass_plugin() {
    return {"glass",
            "A dielectric that refracts; the inside of its closed mesh may be tinted.",
            {ior_spec(),
             color_spec("color", "Transmittance after `distance` inside; each part above 0."),
             {.name = "distance",
              .type = ParamType::number,
              .doc = "Path length in the glass after which the transmittance is `color` (Beer's "
                     "law).",
              .unit = "m",
              .fallback = 0.01,
              .min = 1e-6,
              .max = 1e3},
             roughness_spec(0.0)},
            [](const Params& params) -> Material {
                Glass glass;
                glass.ior = float_number(params, "ior");
                glass.roughness = float_number(params, "roughness");
                const Color& color = params.color("color");
                for (int i = 0; i < 3; ++i) {
                    if (!(color[i] > 0 && color[i] <= 1))
                        throw params.error("color", "each part must be above 0 and at most 1");
                    glass.absorption[i] = -std::log(color[i]) / float_number(params, "distance");
                }
                return glass;
            }};
}

Plugin<MakeMaterial> translucent_plugin() {
    return {"translucent",
            "Subsurface scattering under a clear coat in a closed mesh, for wax, marble, fruit "
            "and rice; an open mesh looks like plastic.",
            {paint_spec(Color(0.8F, 0.8F, 0.8F), "Diffuse reflectance of a thick piece."),
             palette_spec(),
             {.name = "distance",
              .type = ParamType::number,
              .doc = "How far light spreads under the surface; for bright colours about the mean "
                     "free path. Measured in the scene, independent of the object's scale.",
              .unit = "m",
              .fallback = 0.001,
              .min = 1e-6,
              .max = 1e3},
             color_spec("spread", "Factor of `distance` for each channel, from 0.001 to 1."),
             roughness_spec(0.3),
             ior_spec()},
            [](const Params& params) -> Material {
                Translucent translucent;
                translucent.paint = make_paint(params);
                translucent.roughness = float_number(params, "roughness");
                translucent.ior = float_number(params, "ior");
                const Color& spread = params.color("spread");
                for (int i = 0; i < 3; ++i)
                    if (!(spread[i] >= 0.001F && spread[i] <= 1))
                        throw params.error("spread", "each part must be from 0.001 to 1");
                translucent.distance = spread * float_number(params, "distance");
                return translucent;
            }};
}

} // namespace

Registry<MakeMaterial> material_table() {
    Registry<MakeMaterial> table("material");
    table.add(matte_plugin());
    table.add(plastic_plugin());
    table.add(metal_plugin());
    table.add(glass_plugin());
    table.add(translucent_plugin());
    table.add(fibre_plugin());
    return table;
}

} // namespace scree
