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

} // namespace scree
