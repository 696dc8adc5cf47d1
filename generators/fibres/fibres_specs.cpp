// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/fibres/fibres_specs.h"

#include "model/material.h"

namespace scree::fibres {

namespace {

ParamSpec mesh_spec(std::string name, std::string doc) {
    return {.name = std::move(name),
            .type = ParamType::object,
            .families = {"mesh"},
            .doc = std::move(doc),
            .optional = true};
}

ParamSpec turn_spec(std::string name, std::string doc, const Range& fallback) {
    return {.name = std::move(name),
            .type = ParamType::range,
            .doc = std::move(doc),
            .unit = "deg",
            .fallback = fallback,
            .min = -180.0,
            .max = 180.0};
}

ParamSpec choice_spec(std::string name, std::string doc, std::vector<std::string> choices,
                      std::string fallback) {
    return {.name = std::move(name),
            .type = ParamType::choice,
            .doc = std::move(doc),
            .fallback = std::move(fallback),
            .choices = std::move(choices)};
}

ParamSpec flag_spec(std::string name, std::string doc, bool fallback) {
    return {.name = std::move(name),
            .type = ParamType::boolean,
            .doc = std::move(doc),
            .fallback = fallback};
}

ParamSpec integer_spec(std::string name, std::string doc, std::int64_t fallback, double min,
                       double max) {
    return {.name = std::move(name),
            .type = ParamType::integer,
            .doc = std::move(doc),
            .fallback = fallback,
            .min = min,
            .max = max};
}

std::vector<ParamSpec> shape_specs() {
    return {
        mesh_spec("target", "The closed shape that fibres fill; required, but with roots."),
        {.name = "position",
         .type = ParamType::vector3,
         .doc = "Where the origin of the target, or of the roots, is put.",
         .unit = "m",
         .fallback = Vec3(0.0F)},
        integer_spec("count", "How many fibres.", 2048, 1, 1e7),
        {.name = "length",
         .type = ParamType::range,
         .doc = "Of each fibre, uniform in the range; half the longest side of the target, or a "
                "fifth of that of the roots, unless given.",
         .unit = "m",
         .optional = true,
         .min = 0.0,
         .above_min = true},
        integer_spec("segments", "Of each fibre.", 32, 1, 256),
        {.name = "radius",
         .doc = "Of the fibres, less than an eighth of their length; the length / 250 unless "
                "given.",
         .unit = "m",
         .optional = true,
         .min = 0.0,
         .above_min = true},
        number_spec("taper", "Radius of the tip over that of the root.", "", 1, 0, 1),
        turn_spec("theta",
                  "By how much the next segment turns about the carried z axis, at right angles to "
                  "the segment: the crimp.",
                  {-10.8, 10.8}),
        turn_spec("phi",
                  "By how much it turns about the carried y axis, along the segment: the twist.",
                  {0, 0}),
    };
}

std::vector<ParamSpec> forming_specs() {
    return {
        choice_spec("adjustment",
                    "How fibres are moved into the target, without bending: nearest, by damped "
                    "Gauss-Newton steps on how far their vertices are outside; thesis, by the best "
                    "of 12 moves (Sakurai 2013, 5.2.2.2).",
                    {"none", "thesis", "nearest"}, "nearest"),
        flag_spec("contact", "Fibres are bent until they do not overlap.", true),
        flag_spec("gravity",
                  "Fibres fall and come to rest on the floor, in the container and on each other.",
                  false),
        number_spec("tolerance",
                    "How deep fibres may be in each other and outside of the target, in radii.", "",
                    0.05, 0.01, 1),
        number_spec("stiffness", "How much fibres keep their shape while contact bends them.", "",
                    0.2, 0, 1),
        number_spec("friction", "Coulomb's coefficient, between fibres and with what holds them.",
                    "", 0.5, 0, 2),
        integer_spec("max_iterations", "After which contact ends, met or not.", 500, 1, 1e5),
        mesh_spec("container",
                  "What fibres stay out of and rest on or in, such as a bowl: a solid, or a sheet "
                  "when the mesh is open."),
        {.name = "container_position",
         .type = ParamType::vector3,
         .doc = "Where the origin of the container is put; `position` does not move it.",
         .unit = "m",
         .fallback = Vec3(0.0F)},
        {.name = "floor",
         .doc = "Height that fibres stay above.",
         .unit = "m",
         .optional = true,
         .min = -1e6,
         .max = 1e6},
    };
}

std::vector<ParamSpec> flow_specs() {
    return {
        // Declared without a unit, since the values of fields are not converted: they stay in
        // degrees.
        {.name = "flow",
         .type = ParamType::field,
         .doc = "Which way fibres run, in degrees from +x towards +z: a number, or a field over "
                "(x, z).",
         .optional = true},
        {.name = "flow_rise",
         .type = ParamType::field,
         .doc = "Degrees by which the flow rises above level; 0 unless given, -90 is down.",
         .optional = true,
         .min = -90.0,
         .max = 90.0},
        number_spec("flow_strength",
                    "Share of the angle by which each segment turns towards the flow.", "", 0.5, 0,
                    1),
        mesh_spec("roots",
                  "Fibres begin on this mesh, evenly spread, along its normals, in place of "
                  "filling a target."),
    };
}

} // namespace

std::vector<ParamSpec> fibres_specs() {
    std::vector<ParamSpec> specs = shape_specs();
    for (const auto& part : {forming_specs(), flow_specs()})
        specs.insert(specs.end(), part.begin(), part.end());
    specs.push_back(choice_spec("curve",
                                "linear: cylinders, which are what contact is exact for; bspline: "
                                "smooth curves, a piece for about three segments.",
                                {"linear", "bspline"}, "linear"));
    specs.push_back(material_spec("Of all fibres"));
    specs.push_back({.name = "seed",
                     .type = ParamType::integer,
                     .doc = "Another seed, other fibres.",
                     .fallback = std::int64_t{1},
                     .min = 0.0});
    return specs;
}

} // namespace scree::fibres
