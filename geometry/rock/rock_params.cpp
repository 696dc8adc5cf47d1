// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/rock/rock_params.h"

#include <fmt/format.h>

#include <algorithm>

namespace scree {

namespace {

ParamSpec count_spec(std::string name, std::string doc, int fallback, double max) {
    return {.name = std::move(name),
            .type = ParamType::integer,
            .doc = std::move(doc),
            .fallback = std::int64_t{fallback},
            .min = 0.0,
            .max = max};
}

} // namespace

std::vector<ParamSpec> rock_specs() {
    const RockSettings usual;
    return {
        {.name = "axes",
         .type = ParamType::vector2,
         .doc =
             "The middle and the shortest axis, each as a share of the longest; fragments average "
             "{0.7, 0.5}.",
         .fallback = Vec2(usual.b_over_a, usual.c_over_a),
         .pair = "{b/a, c/a}"},
        number_spec("faces", "Mean count of large faces.", "", usual.faces, 4, 20),
        number_spec("scatter", "How far the three sets of joints stray from right angles.", "",
                    usual.scatter, 0, 0.8),
        number_spec("wear", "0: just broken; 1: a round pebble.", "", usual.wear, 0, 1),
        count_spec("chips", "Corners that are knocked off.", usual.chips, 40),
        count_spec("scars", "Hollows where flakes came off.", usual.scars, 12),
        count_spec("cracks", "Open cracks along the joints.", usual.cracks, 6),
        number_spec("hackle", "Height of the small faces of a broken surface, in halves of a.", "",
                    usual.hackle, 0, 0.2),
        number_spec("rough", "Height of the roughness, in halves of a.", "", usual.rough, 0, 0.2),
        number_spec("hurst", "Exponent of the roughness: less is harsher.", "", usual.hurst, 0.3,
                    1),
        number_spec("strata", "How far beds stand out.", "", usual.strata, 0, 2),
    };
}

RockSettings rock_settings(const Params& params) {
    const auto count = [&](const char* name) { return static_cast<int>(params.integer(name)); };
    const Vec2& axes = params.vector2("axes");
    if (!(std::min(axes.x, axes.y) >= least_axis && std::max(axes.x, axes.y) <= 1))
        throw params.error("axes", fmt::format("{{{:g}, {:g}}} is out of range", axes.x, axes.y),
                           fmt::format("expected shares from {:g} to 1", least_axis));
    if (axes.y > axes.x)
        throw params.error("axes", "c is longer than b", "expected {b/a, c/a} with a >= b >= c");
    return {.b_over_a = axes.x,
            .c_over_a = axes.y,
            .faces = params.number("faces"),
            .scatter = params.number("scatter"),
            .wear = params.has("wear") ? params.number("wear") : RockSettings{}.wear,
            .chips = count("chips"),
            .scars = count("scars"),
            .cracks = count("cracks"),
            .hackle = params.number("hackle"),
            .rough = params.number("rough"),
            .hurst = params.number("hurst"),
            .strata = params.number("strata")};
}

ParamSpec rock_triangles_spec(std::string doc, Value fallback) {
    return {.name = "triangles",
            .type = ParamType::integer,
            .doc = std::move(doc),
            .fallback = std::move(fallback),
            .optional = true,
            .min = 320.0,
            .max = 81920.0};
}

int rock_level(double triangles) {
    return static_cast<int>(std::lround(std::sqrt(triangles / 20)));
}

} // namespace scree
