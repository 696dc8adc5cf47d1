// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/elements/elements_specs.h"

#include "model/file_material.h"

#include "geometry/plane/picture_shape.h"

namespace scree {

namespace {

ParamSpec axis(std::string name, std::string doc) {
    return optional_number_spec(std::move(name), std::move(doc), "m", 1e-6, 1e6);
}

ParamSpec rotation(std::string doc) {
    return {.name = "rotation",
            .type = ParamType::range,
            .doc = std::move(doc),
            .unit = "deg",
            .optional = true};
}

std::vector<ParamSpec> component_specs() {
    std::vector<ParamSpec> specs{
        {.name = "shape",
         .type = ParamType::object,
         .families = {"mesh", "region"},
         .doc = "What is placed: a mesh, or a region, which becomes a flat mesh.",
         .optional = true},
    };
    for (ParamSpec& spec : picture_specs())
        specs.push_back(std::move(spec));
    const std::vector<ParamSpec> others{
        {.name = "region",
         .type = ParamType::object,
         .families = {"region"},
         .doc = "Its outline in place of the shape's own; for a mesh that is its silhouette from "
                "above.",
         .optional = true},
        shape_material_spec("Its material"),
        {.name = "weight",
         .type = ParamType::number,
         .doc = "Its share of all elements, relative to the others; mixed evenly with sizes given, "
                "these decide alone.",
         .fallback = 1.0,
         .min = 1e-3,
         .max = 1e3},
        axis("length", "No centre comes nearer along the element's own x axis; from the outline "
                       "unless given, twice the smallest ellipse that holds it."),
        axis("width", "No centre comes nearer across; where only one of both is given, the other "
                      "follows in the outline's proportions."),
        {.name = "margin",
         .type = ParamType::number,
         .doc = "Kept free all round each element; its outline may come so near to others when it "
                "is negative.",
         .unit = "m",
         .fallback = 0.0},
        rotation("In place of the generator's."),
        {.name = "height",
         .type = ParamType::number,
         .doc = "Lifts the component above the ground.",
         .unit = "m",
         .fallback = 0.0},
    };
    specs.insert(specs.end(), others.begin(), others.end());
    return specs;
}

} // namespace

std::vector<ParamSpec> elements_specs() {
    return {
        {.name = "domain",
         .type = ParamType::object,
         .families = {"region"},
         .doc = "What is filled with elements; or surface is.",
         .optional = true},
        {.name = "surface",
         .type = ParamType::object,
         .families = {"mesh"},
         .doc =
             "A mesh on which the elements stand, each along the normal there and turned any way "
             "unless there is a rotation; they keep apart as disks.",
         .optional = true},
        {.name = "torus",
         .type = ParamType::boolean,
         .doc = "The domain, a rectangle, tiles: what sticks out of it comes in on the other side.",
         .fallback = false},
        {.name = "components",
         .type = ParamType::list,
         .doc = "What is placed.",
         .fields = component_specs(),
         .min_items = 1},
        {.name = "mix",
         .type = ParamType::choice,
         .doc = "even: every component is evenly spread by itself, and all are together (Wei "
                "2010); random: only all together, each element any component.",
         .fallback = std::string("even"),
         .choices = {"even", "random"}},
        {.name = "exclusion",
         .type = ParamType::choice,
         .doc = "What keeps other centres away: an ellipse along the element, or a disk, in which "
                "it may turn.",
         .fallback = std::string("ellipse"),
         .choices = {"ellipse", "disk"}},
        {.name = "inside",
         .type = ParamType::choice,
         .doc = "whole: no part of an element sticks out of the domain; centre: the centre of its "
                "outline's box may not.",
         .fallback = std::string("centre"),
         .choices = {"centre", "whole"}},
        {.name = "direction",
         .type = ParamType::field,
         .doc = "Where the elements' x axes point, by place, from +x towards +z.",
         .unit = "deg",
         .optional = true},
        rotation("The elements' own turns, added to the direction; none unless given."),
        {.name = "scale_by",
         .type = ParamType::field,
         .doc = "Multiplies the elements and their distances, by place.",
         .optional = true,
         .min = 1e-6,
         .max = 1e6},
        {.name = "spacing_by",
         .type = ParamType::field,
         .doc = "Multiplies the distances alone, by place: how far apart the elements stand: below "
                "1 closer, so that they may overlap.",
         .optional = true,
         .min = 1e-3,
         .max = 1e6},
        {.name = "relax",
         .type = ParamType::integer,
         .doc = "Steps in which the elements push each other apart, for the most even spread; 30 "
                "are enough for several components.",
         .fallback = std::int64_t{0},
         .min = 0.0,
         .max = 10000.0},
        {.name = "background",
         .type = ParamType::path,
         .doc = "A PNG, JPEG, EXR, HDR or SVG under a baked picture of the elements, which fills the "
                "domain's bounding box; for one colour, an SVG with a rectangle of it.",
         .optional = true},
        {.name = "seed",
         .type = ParamType::integer,
         .doc = "Another seed, other places.",
         .fallback = std::int64_t{0},
         .min = 0.0},
    };
}

} // namespace scree
