// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/fibre_table.h"

#include "model/fibre_color.h"
#include "model/table_tools.h"

namespace scree {

namespace {

// Indices of refraction: hair by d'Eon et al. 2011; the others the mean over directions, (n_along +
// 2 n_across) / 3, of Morton & Hearle 2008, "Physical properties of textile fibres", table 24.1.
// The hair's colour is that of brown hair, with an absorption of 1.3 times that of eumelanin
// (0.419, 0.697, 1.37) by d'Eon et al. 2011, and its roughness the usual one; only hair and wool
// have scales. The other roughnesses and colours are by eye: the more even a fibre's section, the
// smoother it is.
struct FibrePreset {
    const char* name;
    Color color;
    double beta_m;
    double beta_n;
    double eta;
    double tilt; // [deg]
};
const FibrePreset presets[] = {
    {"hair", fibre_color(Color(0.419F, 0.697F, 1.37F) * 1.3F, 0.3F), 0.3, 0.3, 1.55, 2},
    {"wool", {0.80F, 0.72F, 0.58F}, 0.45, 0.55, 1.55, 3},
    {"silk", {0.90F, 0.87F, 0.79F}, 0.2, 0.4, 1.56, 0},
    {"polyester", {0.92F, 0.92F, 0.92F}, 0.3, 0.3, 1.6, 0},
    {"cotton", {0.90F, 0.88F, 0.83F}, 0.7, 0.7, 1.55, 0},
};

const FibrePreset& preset_of(const Params& params) {
    return *std::find_if(std::begin(presets), std::end(presets), [&](const FibrePreset& preset) {
        return params.text("preset") == preset.name;
    });
}

std::vector<ParamSpec> fibre_params() {
    std::vector<std::string> names;
    for (const FibrePreset& preset : presets)
        names.emplace_back(preset.name);
    ParamSpec color = paint_spec({}, "Colour of a thick bunch of fibres.");
    color.fallback = {};
    color.optional = true;
    return {{.name = "preset",
             .type = ParamType::choice,
             .doc = "Gives the colour, roughness, index of refraction and tilt that are not given.",
             .fallback = std::string("hair"),
             .choices = names},
            color,
            palette_spec(),
            {.name = "absorption",
             .type = ParamType::color,
             .doc = "Absorption coefficient inside, each part at least 0, in place of color.",
             .unit = "1/radius",
             .optional = true},
            optional_number_spec("beta_m", "Roughness along the fibre.", "", 0.05, 1),
            optional_number_spec("beta_n", "Roughness around the fibre.", "", 0.05, 1),
            optional_number_spec("eta", "Index of refraction relative to air.", "", 1.01, 2),
            optional_number_spec(
                "tilt", "By which the normals of the fibre's scales lean towards the root.", "deg",
                -10, 10)};
}

Paint fibre_paint(const Params& params, const FibrePreset& preset, float beta_n) {
    if (params.has("absorption")) {
        for (const char* other : {"color", "palette"})
            if (params.has(other))
                throw params.error(other, "cannot be given together with absorption",
                                   "give one of both");
        const Color& absorption = params.color("absorption");
        for (int i = 0; i < 3; ++i)
            if (!(absorption[i] >= 0 && absorption[i] <= 1e6F))
                throw params.error("absorption", "each part must be from 0 to 1e6");
        return {{fibre_color(absorption, beta_n), nullptr}, {}};
    }
    if (params.has("color"))
        return make_paint(params);
    Params with_color = params;
    with_color.set("color", preset.color);
    return make_paint(with_color);
}

} // namespace

Plugin<MakeMaterial> fibre_plugin() {
    return {"fibre",
            "A fibre that is too thin to be seen singly, such as hair, wool or cotton; for curves "
            "and strands (Chiang et al. 2016).",
            fibre_params(), [](const Params& params) -> Material {
                const FibrePreset& preset = preset_of(params);
                const auto given = [&](const char* name, double otherwise) {
                    return params.has(name) ? float_number(params, name)
                                            : static_cast<float>(otherwise);
                };
                Fibre fibre;
                fibre.beta_m = given("beta_m", preset.beta_m);
                fibre.beta_n = given("beta_n", preset.beta_n);
                fibre.eta = given("eta", preset.eta);
                fibre.tilt = given("tilt", radians(preset.tilt));
                fibre.paint = fibre_paint(params, preset, fibre.beta_n);
                return fibre;
            }};
}

} // namespace scree
