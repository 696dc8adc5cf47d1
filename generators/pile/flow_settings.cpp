// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/pile/flow_settings.h"

namespace scree {

namespace {

Vec3 unit(const Params& params, const char* name) {
    const Vec3& v = params.vector3(name);
    if (!(v.length() > 1e-6F))
        throw params.error(name, "has no direction", "expected a vector other than {0, 0, 0}");
    return v.normalized();
}

} // namespace

std::vector<ParamSpec> flow_specs() {
    return {
        {.name = "direction",
         .type = ParamType::vector3,
         .doc = "The same direction everywhere, in the target's frame.",
         .optional = true},
        {.name = "about",
         .type = ParamType::vector3,
         .doc = "Round an axis of this direction in the target's frame.",
         .optional = true},
        {.name = "centre",
         .type = ParamType::vector3,
         .doc = "A point of that axis in the target's frame; its origin unless given.",
         .unit = "m",
         .optional = true},
        // Declared without a unit, since the values of fields are not converted: they stay in
        // degrees.
        {.name = "heading",
         .type = ParamType::field,
         .doc = "Level, in degrees from +x towards +z: a field over (x, z) of the target's frame.",
         .optional = true},
        {.name = "turn",
         .type = ParamType::field,
         .doc = "Degrees by which all of it is turned on the surface, anticlockwise seen from "
                "outside: a number, or a field over (x, z) of the target's frame.",
         .optional = true},
    };
}

OrientationFlow orientation_flow(const Params& params) {
    const int kinds =
        int{params.has("direction")} + int{params.has("about")} + int{params.has("heading")};
    if (kinds != 1)
        throw Error({.where = params.where(),
                     .path = params.path(),
                     .message = kinds == 0 ? "the flow has no direction"
                                           : "the flow has more than one direction",
                     .hint = "expected one of direction, about and heading"});
    if (params.has("centre") && !params.has("about"))
        throw params.error("centre", "is given without an axis", "expected about beside it");
    OrientationFlow flow =
        params.has("direction") ? OrientationFlow::constant(unit(params, "direction"))
        : params.has("about")
            ? OrientationFlow::swirl(unit(params, "about"),
                                     params.has("centre") ? params.vector3("centre") : Vec3(0))
            : OrientationFlow::heading(field_of(params, "heading"));
    if (params.has("turn"))
        flow.set_turn(field_of(params, "turn"));
    return flow;
}

} // namespace scree
