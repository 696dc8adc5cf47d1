// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes/table.h"

#include "core/image_params.h"
#include "core/located.h"
#include "geometry/plane/image_channel.h"
#include "shapes/field/grid_field.h"
#include "shapes/field/plain_fields.h"
#include "shapes/field/sampled_function.h"

#include <fmt/format.h>

namespace scree {

namespace {

using FieldPointer = std::shared_ptr<const Field>;

ParamSpec extent(std::string name, std::string doc) {
    return {.name = std::move(name),
            .type = ParamType::number,
            .doc = std::move(doc),
            .unit = "m",
            .min = 1e-6,
            .max = 1e6};
}

ParamSpec place(std::string name, std::string doc) {
    return {
        .name = std::move(name), .type = ParamType::vector2, .doc = std::move(doc), .unit = "m"};
}

ParamSpec centre(std::string doc) {
    ParamSpec spec = place("centre", std::move(doc));
    spec.fallback = Vec2(0.0);
    return spec;
}

ParamSpec value(std::string name, std::string doc, double fallback) {
    return number_spec(std::move(name), std::move(doc), "", fallback, -1e9, 1e9);
}

ParamSpec flag(std::string name, std::string doc) {
    return {.name = std::move(name),
            .type = ParamType::boolean,
            .doc = std::move(doc),
            .fallback = false};
}

ParamSpec angle_flag() {
    return flag("angle", "The values are directions in degrees: 359 is next to 0.");
}

ParamSpec nearest_flag() {
    return flag("nearest", "Takes the nearest sample instead of interpolating: for class numbers.");
}

/// A field of `grid` over width x depth about the centre. When `at_border`, the outermost samples
/// lie on the border, otherwise every sample lies in the middle of one of equal cells.
FieldPointer laid_out(const Params& params, SampleGrid grid, bool at_border) {
    const Vec2 size(params.number("width"), params.number("depth"));
    const Vec2 counts(grid.columns, grid.rows);
    grid.angle = params.flag("angle");
    grid.torus = params.flag("torus");
    grid.stepped = params.flag("nearest");
    for (unsigned axis = 0; axis < 2; ++axis) {
        const bool spread = at_border && counts[axis] > 1;
        grid.step[axis] = size[axis] / (spread ? counts[axis] - 1 : counts[axis]);
        grid.first[axis] =
            params.vector2("centre")[axis] - size[axis] / 2 + (at_border ? 0 : grid.step[axis] / 2);
    }
    return std::make_shared<const GridField>(std::move(grid));
}

FieldPointer image_field(const Params& params) {
    const Image image = located(params, "path", [&] {
        return read_data_image(params.text("path"), image_options(params, "path"));
    });
    SampleGrid grid{.columns = image.width, .rows = image.height};
    grid.values =
        located(params, "channel", [&] { return channel_values(image, params.text("channel")); });
    const double low = params.number("low");
    const double high = params.has("high")     ? params.number("high")
                        : params.flag("angle") ? 360.0
                                               : 1.0;
    for (float& value : grid.values) {
        value = static_cast<float>(low + (high - low) * double{value});
        if (!std::isfinite(value))
            throw params.error("path", "a pixel's value is too large");
    }
    return laid_out(params, std::move(grid), false);
}

Plugin<MakeField> image_plugin() {
    ParamSpec high = value("high", "Value of a pixel of 1; 1 when not given, 360 for angles.", 1);
    high.fallback = {};
    high.optional = true;
    return {"image",
            "An image stretched over the ground, its top row on the far side (-z); values as "
            "stored, without colour conversion, interpolated bilinearly between pixels.",
            {{.name = "path", .type = ParamType::path, .doc = "A PNG, JPEG, EXR or HDR."},
             layer_spec(),
             extent("width", "Of the whole image along x."),
             extent("depth", "Of the whole image along z."),
             {.name = "channel",
              .type = ParamType::choice,
              .doc = "Which channel of the image gives the value.",
              .fallback = std::string("luminance"),
              .choices = {"luminance", "r", "g", "b", "a"}},
             value("low", "Value of a pixel of 0.", 0),
             std::move(high),
             angle_flag(),
             nearest_flag(),
             flag("torus", "The image repeats; otherwise its border values extend outwards."),
             centre("Position of the middle of the image.")},
            image_field};
}

FieldPointer function_field(const Params& params) {
    SampleGrid grid = located(params, "value", [&] {
        return parse_samples(params.text("value"), FunctionSamples::most);
    });
    return laid_out(params, std::move(grid), !params.flag("torus"));
}

Plugin<MakeField> function_plugin() {
    return {"function",
            "A function of the script, sampled on a grid when the script runs.",
            {{.name = "value",
              .type = ParamType::function,
              .doc = "Gives the value at a point, in metres: function(x, z) return ... end."},
             extent("width", "Of the grid along x; its border values extend outwards."),
             extent("depth", "Of the grid along z."),
             {.name = "resolution",
              .type = ParamType::integer,
              .doc = "Samples along the longer side.",
              .fallback = std::int64_t{FunctionSamples::usual},
              .min = FunctionSamples::least,
              .max = FunctionSamples::most},
             angle_flag(),
             nearest_flag(),
             flag("torus", "The grid repeats."),
             centre("Position of the middle of the grid.")},
            function_field};
}

Plugin<MakeField> gradient_plugin() {
    return {"gradient",
            "A ramp between two points, constant beyond them.",
            {place("from", "Start of the ramp."), place("to", "End of the ramp."),
             value("low", "Value at the start and before it.", 0),
             value("high", "Value at the end and beyond it.", 1),
             flag("radial", "Level lines are circles about `from` instead of straight lines.")},
            [](const Params& params) -> FieldPointer {
                const Vec2& from = params.vector2("from");
                const Vec2& to = params.vector2("to");
                if (!((to - from).length() > 1e-9))
                    throw params.error(
                        "to", fmt::format("is the same point as from: {{{}, {}}}", to.x, to.y));
                return std::make_shared<const GradientField>(
                    from, to, Range{params.number("low"), params.number("high")},
                    params.flag("radial"));
            }};
}

Plugin<MakeField> whirl_plugin() {
    return {"whirl",
            "Directions around a centre, in degrees.",
            {centre("The centre."),
             // Declared without a unit, since the values of the field are in degrees too.
             {.name = "turn",
              .type = ParamType::number,
              .doc = "Rotation from the outward direction, in degrees: 0 gives rays, 90 circles, "
                     "between them spirals.",
              .fallback = 90.0,
              .min = -360.0,
              .max = 360.0}},
            [](const Params& params) -> FieldPointer {
                return std::make_shared<const WhirlField>(params.vector2("centre"),
                                                          params.number("turn"));
            }};
}

} // namespace

Registry<MakeField> field_table() {
    Registry<MakeField> table("field");
    table.add(image_plugin());
    table.add(function_plugin());
    table.add(gradient_plugin());
    table.add(whirl_plugin());
    return table;
}

} // namespace scree
