// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/pile/orientation_flow.h"

namespace scree {

namespace {

// Sine of the angle to the normal below which the projection's direction is noise.
constexpr float least_projection = 1e-4F;

Vec2 ground(const Imath::V3d& position) { return {position.x, position.z}; }

Vec3 unit(const Params& params, const char* name) {
    const Vec3& v = params.vector3(name);
    if (!(v.length() > 1e-6F))
        throw params.error(name, "has no direction", "expected a vector other than {0, 0, 0}");
    return v.normalized();
}

} // namespace

OrientationFlow OrientationFlow::constant(const Vec3& direction) {
    return {Kind::constant, direction.normalized()};
}

OrientationFlow OrientationFlow::swirl(const Vec3& axis, const Vec3& centre) {
    OrientationFlow flow(Kind::swirl, axis.normalized());
    flow.centre_ = centre;
    return flow;
}

OrientationFlow OrientationFlow::heading(std::shared_ptr<const Field> angle) {
    OrientationFlow flow(Kind::heading, Vec3(0));
    flow.heading_ = std::move(angle);
    return flow;
}

Vec3 OrientationFlow::at(const Imath::V3d& position) const {
    switch (kind_) {
    case Kind::constant:
        return direction_;
    case Kind::swirl:
        return direction_.cross(Vec3(position - Imath::V3d(centre_))).normalized();
    case Kind::heading: {
        const double angle = radians(heading_->at(ground(position)));
        return {static_cast<float>(std::cos(angle)), 0, static_cast<float>(std::sin(angle))};
    }
    }
    return {};
}

Vec3 OrientationFlow::tangent(const Imath::V3d& position, const Vec3& normal) const {
    const Vec3 flow = at(position);
    Vec3 tangent = flow - normal * normal.dot(flow);
    tangent = tangent.length() > least_projection ? tangent.normalized() : level_line(normal);
    if (turn_) {
        const double angle = radians(turn_->at(ground(position)));
        tangent = tangent * static_cast<float>(std::cos(angle)) +
                  normal.cross(tangent) * static_cast<float>(std::sin(angle));
    }
    return tangent;
}

Vec3 level_line(const Vec3& normal) {
    const Vec3 u = Vec3(0, 1, 0).cross(normal);
    return u.length() > 1e-4F ? u.normalized() : Vec3(1, 0, 0);
}

std::vector<ParamSpec> flow_specs() {
    return {
        {.name = "direction",
         .type = ParamType::vector3,
         .doc = "The same direction everywhere.",
         .optional = true},
        {.name = "about",
         .type = ParamType::vector3,
         .doc = "Round an axis of this direction.",
         .optional = true},
        {.name = "centre",
         .type = ParamType::vector3,
         .doc = "A point of that axis.",
         .unit = "m",
         .optional = true},
        // Declared without units: the fields have degrees, as the script.
        {.name = "heading",
         .type = ParamType::field,
         .doc = "Level, in degrees from +x towards +z: a field over the ground.",
         .optional = true},
        {.name = "turn",
         .type = ParamType::field,
         .doc = "Degrees by which all of it is turned on the surface, anticlockwise seen from "
                "outside: a number, or a field over the ground.",
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
