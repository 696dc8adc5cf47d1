// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/table.h"

#include "model/table_tools.h"

namespace scree {

namespace {

struct FilterName {
    const char* name;
    Filter filter;
    float radius; // default [pixels]
};
// Radii: box and triangle by definition; the others as PBRT-v4 and Cycles (width 1.5 px) use them.
const FilterName filter_names[] = {{"blackman_harris", Filter::blackman_harris, 1.5F},
                                   {"gaussian", Filter::gaussian, 1.5F},
                                   {"triangle", Filter::triangle, 1.0F},
                                   {"box", Filter::box, 0.5F}};

ParamSpec count_spec(std::string name, std::string doc, std::string unit, std::int64_t fallback,
                     double max) {
    return {.name = std::move(name),
            .type = ParamType::integer,
            .doc = std::move(doc),
            .unit = std::move(unit),
            .fallback = fallback,
            .min = 1.0,
            .max = max};
}

} // namespace

std::vector<ParamSpec> film_params() {
    std::vector<std::string> names;
    for (const FilterName& row : filter_names)
        names.emplace_back(row.name);
    return {count_spec("width", "Width of the picture.", "pixels", 1280, 16384),
            count_spec("height", "Height of the picture.", "pixels", 720, 16384),
            count_spec("samples", "Paths per pixel.", "", 64, 1 << 20),
            count_spec("depth", "Maximum path length; 1 shows light sources only, 2 direct light.",
                       "", 16, 1000),
            {.name = "filter",
             .type = ParamType::choice,
             .doc = "Reconstruction filter.",
             .fallback = std::string("blackman_harris"),
             .choices = names},
            {.name = "radius",
             .type = ParamType::number,
             .doc = "Radius of the filter; the filter's usual one when not given.",
             .unit = "pixels",
             .optional = true,
             .min = 0.1,
             .max = 8.0},
            {.name = "clamp",
             .type = ParamType::number,
             .doc = "Upper limit of one indirect contribution; removes fireflies and loses their "
                    "energy, so that the picture gets darker.",
             .optional = true,
             .min = 0.0,
             .max = 1e9,
             .above_min = true},
            {.name = "regularise",
             .type = ParamType::number,
             .doc = "Least roughness of what a path meets after a diffuse bounce: caustics get "
                    "softer and have fewer fireflies, and hardly any light is lost; 0.2 to 0.4 is "
                    "usual. 0: the picture is exact.",
             .fallback = 0.0,
             .min = 0.0,
             .max = 1.0},
            {.name = "exposure",
             .type = ParamType::number,
             .doc = "Exposure of the displayed picture.",
             .unit = "stops",
             .fallback = 0.0,
             .min = -20.0,
             .max = 20.0}};
}

FilmSettings film_settings(const Params& params) {
    FilmSettings film;
    film.width = static_cast<int>(params.integer("width"));
    film.height = static_cast<int>(params.integer("height"));
    film.samples = static_cast<int>(params.integer("samples"));
    film.depth = static_cast<int>(params.integer("depth"));
    for (const FilterName& row : filter_names)
        if (params.text("filter") == row.name) {
            film.filter = row.filter;
            film.radius = row.radius;
        }
    if (params.has("radius"))
        film.radius = float_number(params, "radius");
    if (params.has("clamp"))
        film.clamp = float_number(params, "clamp");
    film.regularise = float_number(params, "regularise");
    film.exposure = float_number(params, "exposure");
    return film;
}

} // namespace scree
