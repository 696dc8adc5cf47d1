// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/pile/pile_specs.h"

#include "model/file_material.h"

#include "generators/pile/flow_settings.h"

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

std::vector<ParamSpec> variation_specs() {
    return {
        {.name = "shapes",
         .type = ParamType::integer,
         .doc = "How many shapes there are, of which every component has one at random.",
         .fallback = std::int64_t{8},
         .min = 1.0,
         .max = 256.0},
        {.name = "bend",
         .type = ParamType::number,
         .doc = "Most angle by which it is bent from end to end, towards any side.",
         .unit = "deg",
         .fallback = 0.0,
         .min = 0.0,
         .max = 180.0},
        {.name = "twist",
         .type = ParamType::number,
         .doc = "Most angle by which its ends are turned against each other, either way.",
         .unit = "deg",
         .fallback = 0.0,
         .min = 0.0,
         .max = 360.0},
        {.name = "stretch",
         .type = ParamType::number,
         .doc = "Most share by which it is longer or shorter; its volume stays the same.",
         .fallback = 0.0,
         .min = 0.0,
         .max = 0.5},
        {.name = "scale",
         .type = ParamType::range,
         .doc = "Factors of its size, evenly over the shapes.",
         .fallback = Range{1.0, 1.0},
         .min = 0.1,
         .max = 10.0},
    };
}

ParamSpec own(ParamSpec spec) {
    spec.optional = true;
    return spec;
}

std::vector<ParamSpec> component_specs() {
    return {
        {.name = "shape",
         .type = ParamType::object,
         .families = {"mesh"},
         .doc = "What is piled: a closed mesh, or a sheet. Its y axis points outwards before it is "
                "turned."},
        shape_material_spec("Its material"),
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
        {.name = "variation",
         .type = ParamType::record,
         .doc = "How its shapes differ, about the centre of its bounding box and along its longest "
                "side.",
         .optional = true,
         .fields = variation_specs()},
    };
}

std::vector<ParamSpec> cut_specs() {
    return {
        {.name = "normal",
         .type = ParamType::vector3,
         .doc = "Points to what is left out, in the target's frame.",
         .fallback = Vec3(0, 0, 1)},
        {.name = "point",
         .type = ParamType::vector3,
         .doc = "Lies in the plane, in the target's frame.",
         .unit = "m",
         .fallback = Vec3(0)},
    };
}

/// What is piled on what.
std::vector<ParamSpec> target_specs() {
    return {
        {.name = "target",
         .type = ParamType::object,
         .families = {"mesh"},
         .doc = "The shape whose surface is covered."},
        {.name = "position",
         .type = ParamType::point3,
         .doc = "Where the target's origin stands. The target's frame is moved there with the pile "
                "and with all that is given in it: floor, cut and flow.",
         .unit = "m",
         .fallback = WideVec3(0)},
        {.name = "turn",
         .type = ParamType::number,
         .doc =
             "By which the target's frame, with the whole pile, is turned about the upright axis "
             "through the target's origin.",
         .unit = "deg",
         .fallback = 0.0,
         .min = -36000,
         .max = 36000},
        {.name = "components",
         .type = ParamType::list,
         .doc = "What is piled.",
         .fields = component_specs(),
         .min_items = 1},
        {.name = "method",
         .type = ParamType::choice,
         .doc = "insertion: each component moves outwards to the first place where it is free of "
                "those before it; thesis: the method as published, which counts vertices in "
                "medial balls and lets meshes overlap; relax: more than fit are strewn at once, "
                "pushed apart with all degrees of freedom, and gaps filled by insertion.",
         .fallback = std::string("insertion"),
         .choices = {"insertion", "thesis", "relax"}},
        {.name = "fill",
         .type = ParamType::choice,
         .doc = "surface: the target's skin; solid: its inside too, on shells from the innermost "
                "outwards.",
         .fallback = std::string("surface"),
         .choices = {"surface", "solid"}},
        {.name = "shells",
         .type = ParamType::integer,
         .doc = "How many shells of a solid are filled, from the surface inwards; all unless "
                "given.",
         .optional = true,
         .min = 1.0,
         .max = 1e5},
        {.name = "cut",
         .type = ParamType::record,
         .doc = "A plane in the target's frame: what lies beyond it is left out of the finished "
                "pile, so that one sees inside.",
         .optional = true,
         .fields = cut_specs()},
    };
}

/// How far apart, how turned, and how far it moves.
std::vector<ParamSpec> placing_specs() {
    return {
        own(spacing("C_radius: how far apart components are tried, in radii of their largest "
                    "inner ball, or, of a sheet, in halves of the radius of a disk of its area; 3 "
                    "unless given, 1 with the thesis's method.")),
        own(refine("C_refine: how far outwards they may move, in halves of that distance; unless "
                   "given, 2 with the thesis's method, otherwise as far as three such radii.")),
        own(rotation("Widths of the ranges, even to both sides, by which they are turned at "
                     "random: about v, which points outwards, then about u, the surface's level "
                     "line, and w, across; unless given, {0, 360, 0}, along a flow none.")),
        {.name = "frame",
         .type = ParamType::choice,
         .doc = "surface: v is the surface's normal; flow: and u follows a flow; global: u, v and "
                "w are the x, y and z axes of the target's frame.",
         .fallback = std::string("surface"),
         .choices = {"surface", "global", "flow"}},
        {.name = "flow",
         .type = ParamType::record,
         .doc = "What u follows along the surface with frame = \"flow\", in the target's frame.",
         .optional = true,
         .fields = flow_specs()},
        {.name = "overlap",
         .type = ParamType::number,
         .doc = "T: how deep components may reach into each other, in radii of the largest inner "
                "ball of the smaller; 0.3 and more hold a printed object together.",
         .fallback = 0.0,
         .min = 0.0,
         .max = 1.0},
        {.name = "settle",
         .type = ParamType::integer,
         .doc = "Steps, at most, in which a component that insertion has found a place for sinks "
                "towards the surface, slides and turns along those in its way until it rests on "
                "them; 0: it stays where it came free.",
         .fallback = std::int64_t{0},
         .min = 0.0,
         .max = 1000.0},
        {.name = "settle_turn",
         .type = ParamType::number,
         .doc =
             "By how much it may turn then; unless given, 30 with frame = \"surface\", otherwise "
             "not at all.",
         .unit = "deg",
         .optional = true,
         .min = 0.0,
         .max = 180.0},
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
                "from outside, or nothing more finds room; 0.99 unless given; 0: one pass.",
         .optional = true,
         .min = 0.0,
         .max = 1.0},
        {.name = "removal",
         .type = ParamType::number,
         .doc = "D, of the thesis's method: what overlaps by more in the end goes; in radii of the "
                "largest inner ball.",
         .optional = true,
         .min = 0.0,
         .max = 1.0},
    };
}

/// Whether it would stay, and what is measured.
std::vector<ParamSpec> support_specs() {
    return {
        {.name = "support",
         .type = ParamType::choice,
         .doc =
             "Whether components would stay where they are: none: not looked at; report: counted "
             "in the facts; remove: what would fall, and what then falls, is taken away.",
         .fallback = std::string("none"),
         .choices = {"none", "report", "remove"}},
        {.name = "adhesive",
         .type = ParamType::boolean,
         .doc = "What touches the target sticks to it; otherwise the pile stands by itself, on the "
                "floor.",
         .fallback = true},
        {.name = "floor",
         .type = ParamType::number,
         .doc = "Of support: height of a level floor that counts as holding components up, in the "
                "target's frame; unless given, there is none, or, if nothing sticks to the target, "
                "one under the lowest component.",
         .unit = "m",
         .optional = true,
         .min = -1e4,
         .max = 1e4},
        {.name = "contact",
         .type = ParamType::number,
         .doc = "Gap that still counts as touching, in radii of the largest inner ball of the "
                "smaller.",
         .fallback = 0.2,
         .min = 0.001,
         .max = 0.5},
        {.name = "iterations",
         .type = ParamType::integer,
         .doc = "Of relax: sweeps over all pairs; 60 unless given.",
         .optional = true,
         .min = 1.0,
         .max = 10000.0},
        {.name = "density",
         .type = ParamType::number,
         .doc = "Of relax: the share of the space that what is strewn would fill without overlaps; "
                "0.5 unless given.",
         .optional = true,
         .min = 0.01,
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

} // namespace

std::vector<ParamSpec> pile_specs() {
    std::vector<ParamSpec> specs = target_specs();
    for (const std::vector<ParamSpec>& part : {placing_specs(), support_specs()})
        specs.insert(specs.end(), part.begin(), part.end());
    return specs;
}

} // namespace scree
