// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/layout/layout_specs.h"

#include "model/file_material.h"

namespace scree {

namespace {

std::vector<ParamSpec> component_specs() {
    return {
        {.name = "shape",
         .type = ParamType::object,
         .families = {"mesh", "region"},
         .doc = "What is placed: a mesh, or a region, which becomes a flat mesh."},
        {.name = "region",
         .type = ParamType::object,
         .families = {"region"},
         .doc = "The exclusive region in place of the shape's own; for a mesh that is its "
                "silhouette from above.",
         .optional = true},
        shape_material_spec("Its material"),
        {.name = "weight",
         .type = ParamType::number,
         .doc = "How often it is tried, relative to the others.",
         .fallback = 1.0,
         .min = 0.0,
         .max = 1e6,
         .above_min = true},
        {.name = "margin",
         .type = ParamType::number,
         .doc = "Grows the exclusive region all round, or shrinks it when negative, before "
                "scaling.",
         .unit = "m",
         .fallback = 0.0},
        {.name = "class",
         .type = ParamType::integer,
         .doc = "Where the layout's classes say this number, the component may lie; its place in "
                "the list unless given.",
         .optional = true},
        {.name = "height",
         .type = ParamType::number,
         .doc = "Lifts the component above the ground.",
         .unit = "m",
         .fallback = 0.0},
    };
}

/// What is placed where, and how it varies.
std::vector<ParamSpec> element_specs() {
    return {
        {.name = "method",
         .type = ParamType::choice,
         .doc =
             "naive: random darts; fill_gap: darts where the gaps are wide; saturated: until it "
             "is certain that nothing more fits. Unless given it is saturated, but fill_gap where "
             "that is expected to take more than ten seconds, and beside max_count or "
             "cancellations.",
         .optional = true,
         .choices = {"naive", "fill_gap", "saturated"}},
        {.name = "domain",
         .type = ParamType::object,
         .families = {"region"},
         .doc = "Where elements may lie."},
        {.name = "torus",
         .type = ParamType::boolean,
         .doc = "The domain, a rectangle, tiles: what sticks out of it comes in on the other side.",
         .fallback = false},
        {.name = "components",
         .type = ParamType::list,
         .doc = "What is placed.",
         .fields = component_specs(),
         .min_items = 1},
        {.name = "selection",
         .type = ParamType::choice,
         .doc = "cyclic: each trial takes the next component; weighted: at random by weight. "
                "Cyclic unless the weights differ.",
         .optional = true,
         .choices = {"cyclic", "weighted"}},
        {.name = "inside",
         .type = ParamType::choice,
         .doc = "whole: no part of a region sticks out of the domain; centre: its centre may not.",
         .fallback = std::string("whole"),
         .choices = {"whole", "centre"}},
        {.name = "rotation",
         .type = ParamType::range,
         .doc = "Angles, from +x towards +z; any, or where there is a direction none beside it, "
                "unless given.",
         .unit = "deg",
         .optional = true},
        {.name = "direction",
         .type = ParamType::field,
         .doc = "Added to the angle, by place; the rotation is then the jitter around it.",
         .unit = "deg",
         .optional = true},
        {.name = "scale",
         .type = ParamType::range,
         .doc = "Uniform scales.",
         .fallback = Range{1, 1},
         .min = 1e-6,
         .max = 1e6},
        {.name = "scale_by",
         .type = ParamType::field,
         .doc = "Multiplies the scale, by place.",
         .optional = true,
         .min = 1e-6,
         .max = 1e6},
        {.name = "density",
         .type = ParamType::field,
         .doc = "Multiplies the margins, by place: the elements stand farther apart where it is "
                "large.",
         .optional = true,
         .min = 0.0,
         .max = 1e6},
        {.name = "classes",
         .type = ParamType::field,
         .doc = "Rounded to a whole number, the class of component that may be placed there.",
         .optional = true},
    };
}

/// How long the methods search, and how finely.
std::vector<ParamSpec> search_specs() {
    return {
        {.name = "seed",
         .type = ParamType::integer,
         .doc = "Another seed, another layout.",
         .fallback = std::int64_t{0},
         .min = 0.0},
        {.name = "cancellations",
         .type = ParamType::integer,
         .doc = "Cancelled trials in a row that end the work: 10000 for naive, 200 for fill_gap.",
         .optional = true,
         .min = 1.0,
         .max = 1e12},
        {.name = "candidates",
         .type = ParamType::integer,
         .doc = "fill_gap: points tried per distance field.",
         .fallback = std::int64_t{100},
         .min = 1.0,
         .max = 1e6},
        {.name = "exponent",
         .type = ParamType::integer,
         .doc = "fill_gap: power of the normalised distance that is a pixel's probability.",
         .fallback = std::int64_t{16},
         .min = 0.0,
         .max = 1024.0},
        {.name = "resolution",
         .type = ParamType::integer,
         .doc = "fill_gap: pixels of the distance field along the domain's longest side.",
         .fallback = std::int64_t{512},
         .min = 16.0,
         .max = 8192.0},
        {.name = "epsilon",
         .type = ParamType::number,
         .doc =
             "saturated: in the end nothing fits anywhere with this clearance, as a share of the "
             "smallest inscribed radius.",
         .fallback = 0.01,
         .min = 0.0,
         .max = 1.0,
         .above_min = true},
        {.name = "max_count",
         .type = ParamType::integer,
         .doc = "Stops at this many elements.",
         .optional = true,
         .min = 0.0},
    };
}

} // namespace

std::vector<ParamSpec> layout_specs() {
    std::vector<ParamSpec> specs = element_specs();
    for (ParamSpec& spec : search_specs())
        specs.push_back(std::move(spec));
    return specs;
}

} // namespace scree
