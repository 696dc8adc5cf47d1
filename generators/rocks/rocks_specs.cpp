// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/rocks/rocks_specs.h"

#include "geometry/rock/rock_params.h"
#include "model/file_material.h"

#include <algorithm>
#include <iterator>

namespace scree::rocks {

namespace {

constexpr Preset plain{"plain", 0.1, 0.08, 0, 0.15, 0, 0};
constexpr Preset presets[] = {{"river", 0.8, 0.1, 0, 0.25, 18, 0},
                              {"scree", 0.08, 0.06, 33, 0.1, 0, 0.08},
                              {"moraine", 0.35, 0.2, 0, 0.3, 0, 0},
                              {"desert", 0.2, 0.1, 0, 0.3, 0, 0}};

ParamSpec choice(std::string name, std::string doc, std::vector<std::string> choices,
                 const Value& fallback) {
    return {.name = std::move(name),
            .type = ParamType::choice,
            .doc = std::move(doc),
            .fallback = fallback,
            .optional = std::holds_alternative<std::monostate>(fallback),
            .choices = std::move(choices)};
}

std::vector<ParamSpec> class_specs() {
    const auto swelling = [](std::string name, std::string doc) {
        return ParamSpec{.name = std::move(name),
                         .type = ParamType::vector3,
                         .doc = std::move(doc),
                         .unit = "m",
                         .fallback = Vec3(0)};
    };
    return {
        {.name = "radius",
         .doc =
             "Of the disks of Sakurai & Miyata; their cells, and dropped rocks, are about 1.2 of "
             "it wide.",
         .unit = "m",
         .min = 0.0,
         .max = 1e4,
         .above_min = true},
        {.name = "share", .doc = "Of the ground.", .min = 0.0, .max = 1.0, .above_min = true},
        swelling("widening",
                 "How far the upper vertices of the paper's rocks move outwards: {c_w1, "
                 "c_w2, c_w3}, the base, the part drawn for each rock and that drawn "
                 "for each vertex."),
        swelling("height", "How far they move up, likewise: {c_h1, c_h2, c_h3}."),
    };
}

std::vector<ParamSpec> size_specs() {
    return {
        choice("method",
               "paper: cells of several Voronoi diagrams, those that do not overlap (Sakurai & "
               "Miyata), with gaps between sizes; mosaic: rocks that fill the ground without gaps, "
               "each in a cell of prescribed area; dropped: rocks that fall onto the ground and "
               "each other.",
               {"paper", "mosaic", "dropped"}, std::string("dropped")),
        choice("preset", "Changes what is not given.", {"river", "scree", "moraine", "desert"}, {}),
        {.name = "domain",
         .type = ParamType::object,
         .families = {"region"},
         .doc = "Where rocks have their centres; for paper and mosaic a convex region that holds "
                "the cells."},
        choice("distribution",
               "Of sizes. classes: `sizes`; power: as many are longer than D as D^-exponent says "
               "(Turcotte 1986); area: rocks longer than D cover exp(-q D) of what all cover "
               "(Golombek & Rapp 1997), q = 1.79 + 0.152 / cover in metres. Unless given, classes "
               "with `sizes` and power without.",
               {"classes", "power", "area"}, {}),
        {.name = "sizes",
         .type = ParamType::list,
         .doc = "Rocks of about one size each.",
         .optional = true,
         .fields = class_specs(),
         .min_items = 1},
        optional_number_spec("smallest", "The least longest axis, for power and area.", "m", 1e-4,
                             1e3),
        optional_number_spec("largest", "The greatest longest axis, likewise.", "m", 1e-4, 1e3),
        optional_number_spec("exponent", "For power; 2.5 unless given.", "", 0.5, 4),
        optional_number_spec("cover",
                             "Plan area of all dropped rocks as a share of the domain, 1 unless "
                             "given: over 1 they lie on each other. Multiplies the shares of "
                             "classes.",
                             "", 1e-4, 20),
    };
}

std::vector<ParamSpec> place_specs() {
    return {
        {.name = "ground",
         .type = ParamType::object,
         .families = {"mesh"},
         .doc = "What dropped rocks fall on, from above; a plane unless given.",
         .optional = true},
        {.name = "ground_material",
         .type = ParamType::object,
         .families = {"material"},
         .doc = "Shows the ground, of this material; unless given it is not shown.",
         .optional = true},
        optional_number_spec("slope",
                             "Of the plane, which rises towards -z. 0, but 33 for scree; rocks do "
                             "not rest on more than 36 degrees.",
                             "deg", 0, 60),
        optional_number_spec("burial",
                             "How much of its height a dropped rock sinks into the ground. 0.15, "
                             "but 0.25 for river, 0.1 for scree, 0.3 for moraine and desert.",
                             "", 0, 0.9),
        optional_number_spec("dip",
                             "How far flat rocks dip against the flow, like tiles. 0, but 18 for "
                             "river.",
                             "deg", 0, 45),
        optional_number_spec("flow",
                             "Where the water flows to, from +x towards +z; +x unless given.",
                             "deg", -360, 360),
        optional_number_spec("sorting",
                             "How much the logarithm of the size falls for a metre of height: "
                             "larger rocks roll farther down (Statham 1976). 0, but 0.08 for "
                             "scree.",
                             "1/m", 0, 10),
        {.name = "density",
         .type = ParamType::field,
         .doc = "How likely rocks are, by place; only proportions count.",
         .optional = true,
         .min = 0.0},
        {.name = "size",
         .type = ParamType::field,
         .doc = "Where larger rocks lie: their logarithm is greater by so much as this is. Sizes "
                "stay as they are drawn.",
         .optional = true,
         .min = -100.0,
         .max = 100.0},
    };
}

std::vector<ParamSpec> rock_specs_of_generator() {
    std::vector<ParamSpec> specs = rock_specs();
    for (ParamSpec& spec : specs)
        if (spec.name == "wear") {
            spec.doc +=
                " 0.1, but 0.8 for river, 0.08 for scree, 0.35 for moraine, 0.2 for desert.";
            spec.fallback = {};
            spec.optional = true;
        }
    const std::vector<ParamSpec> more{
        number_spec("spread", "Of b/a and c/a among rocks, standard deviation.", "", 0.12, 0, 0.4),
        optional_number_spec("wear_spread",
                             "Of the wear among rocks, likewise. 0.08, but 0.1 for river and "
                             "desert, 0.06 for scree, 0.2 for moraine.",
                             "", 0, 1),
        optional_number_spec("joint", "Between the rocks of a mosaic; 0.6 mm unless given.", "m", 0,
                             100),
        rock_triangles_spec("About how many triangles each rock has: 20 n^2 for a whole n. By size "
                            "unless given.",
                            {}),
        {.name = "prototypes",
         .type = ParamType::integer,
         .doc = "Different shapes of dropped rocks, beside those of the 30 largest, of which each "
                "has its own; 64 unless given.",
         .optional = true,
         .min = 1.0,
         .max = 10000.0},
        {.name = "unique",
         .type = ParamType::boolean,
         .doc = "Every dropped rock has a shape of its own.",
         .optional = true},
    };
    specs.insert(specs.end(), more.begin(), more.end());
    return specs;
}

} // namespace

const Preset& preset_of(const Params& params) {
    if (!params.has("preset"))
        return plain;
    return *std::find_if(std::begin(presets), std::end(presets), [&](const Preset& preset) {
        return preset.name == params.text("preset");
    });
}

std::vector<ParamSpec> rocks_specs() {
    std::vector<ParamSpec> specs = size_specs();
    for (const auto& part : {place_specs(), rock_specs_of_generator()})
        specs.insert(specs.end(), part.begin(), part.end());
    specs.push_back({.name = "exclusion",
                     .type = ParamType::choice,
                     .doc = "By how much of its radius a site of the paper's method keeps others "
                            "away: half of it, as the text says, or all, as its Fig. 4 says, which "
                            "leaves room for fewer sites than it asks for. half unless given.",
                     .optional = true,
                     .choices = {"half", "full"}});
    specs.push_back(material_spec("Of all rocks"));
    specs.push_back({.name = "materials",
                     .type = ParamType::list,
                     .doc = "Of the rocks, each shape one of them, in turn.",
                     .optional = true,
                     .fields = {{.name = "material",
                                 .type = ParamType::object,
                                 .families = {"material"},
                                 .doc = "One of them."}},
                     .min_items = 1});
    specs.push_back({.name = "measure",
                     .type = ParamType::integer,
                     .doc = "How many dropped rocks are measured: gaps to what holds them, and how "
                            "deep they are in others; none unless given.",
                     .optional = true,
                     .min = 0.0});
    specs.push_back({.name = "seed",
                     .type = ParamType::integer,
                     .doc = "Another seed, other rocks.",
                     .fallback = std::int64_t{0},
                     .min = 0.0});
    return specs;
}

} // namespace scree::rocks
