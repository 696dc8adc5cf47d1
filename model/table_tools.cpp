// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/table_tools.h"

namespace scree {

ParamSpec strength_spec(double fallback, std::string doc, std::string unit) {
    return {.name = "strength",
            .type = ParamType::number,
            .doc = std::move(doc),
            .unit = std::move(unit),
            .fallback = fallback,
            .min = 0.0,
            .max = 1e9};
}

ParamSpec color_spec(std::string name, std::string doc) {
    return {.name = std::move(name),
            .type = ParamType::color,
            .doc = std::move(doc),
            .fallback = Color(1.0F, 1.0F, 1.0F)};
}

void check_color(const Params& params, const std::string& name, const Color& color, float max) {
    for (int i = 0; i < 3; ++i)
        if (!(color[i] >= 0 && color[i] <= max))
            throw params.error(name, max == 1 ? "a reflectance must be from 0 to 1"
                                              : "light must not be negative");
}

float float_number(const Params& params, const std::string& name) {
    return static_cast<float>(params.number(name));
}

ParamSpec paint_spec(const Color& fallback, std::string doc) {
    return {
        .name = "color", .type = ParamType::texture, .doc = std::move(doc), .fallback = fallback};
}

ParamSpec palette_spec() {
    return {.name = "palette",
            .type = ParamType::list,
            .doc = "Colours of which each instance gets a random one, in place of color.",
            .optional = true,
            .fields = {{.name = "color", .type = ParamType::color, .doc = "One of the colours."}},
            .min_items = 1};
}

Paint make_paint(const Params& params) {
    Paint paint{texture_of(params, "color"), {}};
    if (paint.texture.procedural == nullptr)
        check_color(params, "color", paint.texture.constant, 1);
    if (params.has("palette"))
        for (const Params& entry : params.list("palette")) {
            check_color(entry, "color", entry.color("color"), 1);
            paint.palette.push_back(entry.color("color"));
        }
    return paint;
}

} // namespace scree
