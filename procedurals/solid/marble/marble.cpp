// SPDX-License-Identifier: GPL-3.0-or-later
#include "procedurals/solid/marble/marble.h"

#include "core/random.h"
#include "procedurals/solid/marble/marble_as_cpp.h"
#include "procedurals/solid/marble/marble_presets.h"
#include "procedurals/solid/marble/marble_source.h"
#include "procedurals/solid/marble/marble_vector.h"
#include "procedurals/solid/marble/vein_layer.h"
#include "procedurals/solid/solid_procedural.h"
#include "procedurals/solid/solid_specs.h"

#include <algorithm>

namespace scree {

namespace {

using solid::Marble;
using solid::VeinLayer;

const MarblePreset& preset_of(const Params& params) {
    const auto& presets = marble_presets();
    return *std::find_if(presets.begin(), presets.end(), [&](const MarblePreset& preset) {
        return preset.name == params.text("preset");
    });
}

/// The systems of veins given by the user, or those of the preset with the user's changes to the
/// first.
std::vector<MarbleVeins> vein_systems(const Params& params) {
    const double size = params.number("size");
    const auto changed = [&](MarbleVeins veins, const Params& by) {
        veins.color = color_or(by, "vein", veins.color);
        veins.count =
            by.has("vein_count") ? static_cast<int>(by.integer("vein_count")) : veins.count;
        veins.width = by.has("vein_width") ? by.number("vein_width") / size : veins.width;
        veins.diffusion = by.has("diffusion") ? by.number("diffusion") / size : veins.diffusion;
        veins.contrast = number_or(by, "contrast", veins.contrast);
        veins.turbulence = number_or(by, "turbulence", veins.turbulence);
        return veins;
    };
    std::vector<MarbleVeins> systems = preset_of(params).veins;
    if (!params.has("layers")) {
        systems.front() = changed(systems.front(), params);
        return systems;
    }
    const MarbleVeins first = changed(systems.front(), params);
    systems.clear();
    for (const Params& layer : params.list("layers")) {
        systems.push_back(changed(first, layer));
        systems.back().tilt = layer.number("tilt");
    }
    if (systems.size() > MARBLE_MAX_LAYERS)
        throw params.error("layers", "has more than 4 layers");
    return systems;
}

VeinLayer make_layer(const Params& params, const MarbleVeins& veins, unsigned index) {
    const SolidFrame frame = solid_frame(params);
    Random random(static_cast<std::uint64_t>(params.integer("seed")), Purpose::solid_vein, index);
    VeinLayer layer{};
    // The first layer uses the untransformed lattice, so that a cube of the lattice's size shows
    // the paper's faces; the others use other parts of it.
    layer.placement = placement(params, frame, index);
    const double turn = index == 0 ? 0 : random.uniform(0, 2 * pi);
    const Vec3 side = frame.right * static_cast<float>(std::cos(turn)) +
                      frame.up * static_cast<float>(std::sin(turn));
    const Vec3 axis = frame.axis * static_cast<float>(std::cos(veins.tilt)) +
                      side * static_cast<float>(std::sin(veins.tilt));
    layer.axis = as_triple(axis);
    layer.start = axis.dot(frame.origin);
    layer.displacement = as_float(veins.turbulence * cell_length(params));
    layer.strength = as_float(veins.contrast);
    layer.iterations = static_cast<int>(params.integer("iterations"));
    layer.color = {veins.color.x, veins.color.y, veins.color.z};
    if (index == 0 && params.has("veins"))
        list_veins(layer, params, veins);
    else
        scatter_veins(layer, veins, params.number("size"), random);
    tabulate(layer);
    return layer;
}

std::shared_ptr<const Procedural> make_marble(const Params& params) {
    const MarblePreset& preset = preset_of(params);
    const auto as_color = [](const Color& c) { return solid::Triple{c.x, c.y, c.z}; };
    Marble marble{};
    marble.filler = as_color(color_or(params, "filler", preset.filler));
    marble.cloud = as_color(color_or(params, "cloud", preset.cloud));
    marble.cloudiness = as_float(number_or(params, "cloudiness", preset.cloudiness));
    marble.cloud_placement = placement(params, solid_frame(params), 100, 0.8);
    marble.depth = as_float(params.number("vein_height"));
    marble.filler_roughness = marble.vein_roughness = ShadingSample::unset;
    if (params.has("filler_roughness") != params.has("vein_roughness"))
        throw params.error(params.has("filler_roughness") ? "filler_roughness" : "vein_roughness",
                           "filler_roughness and vein_roughness go together: give both or neither");
    if (params.has("filler_roughness")) {
        marble.filler_roughness = as_float(params.number("filler_roughness"));
        marble.vein_roughness = as_float(params.number("vein_roughness"));
    }
    marble.filtered = params.flag("filtered") ? 1 : 0;
    for (const MarbleVeins& veins : vein_systems(params)) {
        const auto index = static_cast<unsigned>(marble.layers);
        marble.layer[marble.layers++] = make_layer(params, veins, index);
    }
    return std::make_shared<SolidProcedural<Marble, solid::marble_at, marble_in_lanes>>(
        make_lattice(params), marble, SolidKernel{marble_source, "Marble", "marble_at"},
        params.flag("scale_with_object"));
}

std::vector<ParamSpec> layer_specs() {
    return {
        preset_color("vein", "Colour of the impurities in the veins."),
        {.name = "vein_count",
         .type = ParamType::integer,
         .doc = "Number of veins per `size` along the axis.",
         .optional = true,
         .min = 0.0,
         .max = double(MARBLE_MAX_VEINS)},
        preset_number("vein_width", "Mean width of a vein where it is full.", "m", 0, 1e4),
        preset_number("diffusion", "Length over which a vein soaks out into the stone to 1/e.", "m",
                      1e-7, 1e4),
        preset_number("contrast", "Share of the vein's colour where it is full.", "", 0, 1),
        preset_number("turbulence",
                      "k: how far the fractal field pushes the layers, in 64ths of `size`.", "", 0,
                      1000),
    };
}

std::vector<ParamSpec> marble_specs() {
    std::vector<std::string> names;
    for (const MarblePreset& preset : marble_presets())
        names.push_back(preset.name);
    std::vector<ParamSpec> specs = {
        {.name = "preset",
         .type = ParamType::choice,
         .doc = "Marble with default colours and veins, which the other parameters override.",
         .fallback = std::string("carrara"),
         .choices = names},
        preset_color("filler", "Colour of the stone itself."),
        preset_color("cloud", "Colour to which the stone goes over in clouds."),
        preset_number("cloudiness", "Share of that colour where clouds are thickest.", "", 0, 1)};
    for (ParamSpec& spec : layer_specs())
        specs.push_back(std::move(spec));
    std::vector<ParamSpec> fields = layer_specs();
    fields.push_back({.name = "tilt",
                      .type = ParamType::number,
                      .doc = "Angle of these layers against the axis.",
                      .unit = "deg",
                      .fallback = 0.0,
                      .min = -90.0,
                      .max = 90.0});
    specs.push_back({.name = "layers",
                     .type = ParamType::list,
                     .doc = "One to four systems of veins in place of the preset's, each on top of "
                            "those before it; defaults are those of the first system.",
                     .optional = true,
                     .fields = std::move(fields),
                     .min_items = 1});
    specs.push_back({.name = "veins",
                     .type = ParamType::list,
                     .doc = "The veins of the first system one by one, in place of `vein_count`.",
                     .optional = true,
                     .fields = {{.name = "at",
                                 .type = ParamType::number,
                                 .doc = "Middle of the vein along the axis, from the origin.",
                                 .unit = "m"},
                                preset_number("width", "Width where it is full.", "m", 0, 1e4),
                                preset_number("diffusion", "Length over which it soaks out to 1/e.",
                                              "m", 1e-7, 1e4)},
                     .min_items = 1});
    specs.push_back({.name = "iterations",
                     .type = ParamType::integer,
                     .doc = "Iterations of the inversion of the displacement; 0: first order.",
                     .fallback = std::int64_t{0},
                     .min = 0.0,
                     .max = 16.0});
    specs.push_back({.name = "vein_height",
                     .type = ParamType::number,
                     .doc = "Height of the veins as bumps; negative: recessed.",
                     .unit = "m",
                     .fallback = 0.0,
                     .min = -1.0,
                     .max = 1.0});
    specs.push_back(preset_number(
        "filler_roughness", "Roughness of the stone; unless given, the material's.", "", 0, 1));
    specs.push_back(preset_number("vein_roughness", "Roughness of the veins.", "", 0, 1));
    return solid_specs(std::move(specs));
}

} // namespace

Plugin<MakeProcedural> marble_plugin() {
    return {"marble",
            "Marble: layers of veins in stone, displaced by a fractal field (Okada et al. "
            "1987), filtered over the pixel.",
            marble_specs(), make_marble};
}

} // namespace scree
