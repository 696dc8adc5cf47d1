// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/pile/pile_specs.h"

namespace scree {

namespace {

ParamSpec spacing(std::string doc) {
    return {.name = "spacing",
            .type = ParamType::number,
            .doc = std::move(doc),
            .min = 0.05,
            .max = 1000.0};
}

ParamSpec refine(std::string doc) {
    return {.name = "refine",
            .type = ParamType::number,
            .doc = std::move(doc),
            .min = 0.0,
            .max = 1000.0};
}

ParamSpec rotation(std::string doc) {
    return {.name = "rotation",
            .type = ParamType::vector3,
            .doc = std::move(doc),
            .unit = "deg",
            .min = 0.0,
            .max = 360.0};
}

ParamSpec with(ParamSpec spec, Value fallback) {
    spec.fallback = std::move(fallback);
    return spec;
}

ParamSpec own(ParamSpec spec) {
    spec.optional = true;
    return spec;
}

std::vector<ParamSpec> component_specs() {
    return {
        {.name = "shape",
         .type = ParamType::mesh,
         .doc = "What is piled: a closed mesh, or a sheet. Its y axis points outwards before it is "
                "turned."},
        {.name = "material",
         .type = ParamType::material,
         .doc = "Its material.",
         .fallback = MaterialId{}},
        {.name = "weight",
         .type = ParamType::number,
         .doc = "How often it is tried, relative to the others, as long as all have sites left.",
         .fallback = 1.0,
         .min = 1e-3,
         .max = 1e3},
        own(spacing("In place of the generator's.")),
        own(refine("In place of the generator's.")),
        own(rotation("In place of the generator's.")),
        {.name = "sheet",
         .type = ParamType::boolean,
         .doc = "The mesh need not be closed: it is a sheet of some thickness.",
         .fallback = false},
        {.name = "thickness",
         .type = ParamType::number,
         .doc = "Of a sheet, half of it to both sides of the mesh; unless given, 2% of the "
                "diameter of a disk of its area.",
         .unit = "m",
         .optional = true,
         .min = 1e-6,
         .max = 1e3},
    };
}

} // namespace

std::vector<ParamSpec> pile_specs() {
    return {
        {.name = "target", .type = ParamType::mesh, .doc = "The shape whose surface is covered."},
        {.name = "components",
         .type = ParamType::list,
         .doc = "What is piled.",
         .fields = component_specs(),
         .min_items = 1},
        {.name = "method",
         .type = ParamType::choice,
         .doc = "insertion: each component moves outwards to the first place where it is free of "
                "those before it; thesis: the method as published, which counts vertices in "
                "medial balls and lets meshes overlap.",
         .fallback = std::string("insertion"),
         .choices = {"insertion", "thesis"}},
        own(spacing("C_radius: how far apart components are tried, in radii of their largest "
                    "inner ball, or, of a sheet, in halves of the radius of a disk of its area; 3 "
                    "unless given, 1 with the thesis's method.")),
        own(refine("C_refine: how far outwards they may move, in halves of that distance; unless "
                   "given, 2 with the thesis's method, otherwise as far as three such radii.")),
        with(rotation("Widths of the ranges, even to both sides, by which they are turned at "
                      "random: about v, which points outwards, then about u, the surface's level "
                      "line, and w, across."),
             Vec3(0, 2 * pi_f, 0)),
        {.name = "frame",
         .type = ParamType::choice,
         .doc = "surface: v is the surface's normal; global: u, v and w are the world's x, y and "
                "z.",
         .fallback = std::string("surface"),
         .choices = {"surface", "global"}},
        {.name = "overlap",
         .type = ParamType::number,
         .doc = "T: how deep components may reach into each other, in radii of the largest inner "
                "ball of the smaller; 0.3 and more hold a printed object together.",
         .fallback = 0.0,
         .min = 0.0,
         .max = 1.0},
        {.name = "sink",
         .type = ParamType::number,
         .doc = "How deep below the surface the centres of the largest inner balls may lie, in "
                "their radii.",
         .fallback = 0.0,
         .min = 0.0,
         .max = 100.0},
        {.name = "cover",
         .type = ParamType::number,
         .doc = "insertion goes on where the surface still shows until this share of it is hidden "
                "from outside, or nothing more finds room; 0: one pass.",
         .fallback = 0.99,
         .min = 0.0,
         .max = 1.0},
        {.name = "removal",
         .type = ParamType::number,
         .doc = "D, of the thesis's method: what overlaps by more in the end goes; in radii of the "
                "largest inner ball.",
         .optional = true,
         .min = 0.0,
         .max = 1.0},
        {.name = "measure",
         .type = ParamType::integer,
         .doc = "How many components, evenly taken from all, the overlap is measured at; 0: it is "
                "not.",
         .fallback = std::int64_t{500},
         .min = 0.0,
         .max = 1e7},
        {.name = "seed",
         .type = ParamType::integer,
         .doc = "Another seed, another pile.",
         .fallback = std::int64_t{0},
         .min = 0.0},
    };
}

} // namespace scree
