// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/pile/component_settings.h"

namespace scree {

namespace {

double thickness_of(const Params& component) {
    if (!component.flag("sheet")) {
        if (component.has("thickness"))
            throw component.error("thickness", "is given, but the component is no sheet",
                                  "expected sheet = true beside it");
        return 0;
    }
    return component.has("thickness")
               ? component.number("thickness")
               : 0.02 * 2 * std::sqrt(area(*component.object<Mesh>("shape")) / pi);
}

/// The number that is given for the component or, failing that, for all.
std::optional<double> given_number(const Params& params, const Params& component,
                                   const char* name) {
    for (const Params* from : {&component, &params})
        if (from->has(name))
            return from->number(name);
    return {};
}

Vec3 rotation_of(const Params& params, const Params& component) {
    for (const Params* from : {&component, &params})
        if (from->has("rotation"))
            return from->vector3("rotation");
    return params.text("frame") == "flow" ? Vec3(0) : Vec3(0, 2 * pi_f, 0);
}

ShapeVariation variation_of(const Params& component) {
    const Params& given = component.record("variation");
    const ShapeVariation variation{
        .shapes = static_cast<std::uint32_t>(given.integer("shapes")),
        .bend = given.number("bend"),
        .twist = given.number("twist"),
        .stretch = given.number("stretch"),
        .scale = given.range("scale"),
    };
    if (!variation.any())
        throw component.error("variation", "varies nothing",
                              "expected bend, twist, stretch or scale");
    return variation;
}

} // namespace

std::vector<ComponentSettings> component_settings(const Params& params) {
    const bool thesis = params.text("method") == "thesis";
    const float target_size = bounds(*params.object<Mesh>("target")).size().length();
    std::vector<ComponentSettings> components;
    for (const Params& given : params.list("components")) {
        ComponentSettings& component = components.emplace_back();
        component.shape = given.object<Mesh>("shape");
        component.shape_place = given.place("shape");
        component.materials = materials_of(given, component.shape.get());
        component.weight = given.number("weight");
        if (bounds(*component.shape).size().length() > target_size)
            given.warn("shape", component.shape->name + " is larger than the target",
                       "a smaller scale of the mesh, or a larger target");
        component.thickness = thickness_of(given);
        component.spacing = given_number(params, given, "spacing").value_or(thesis ? 1 : 3);
        component.refine =
            given_number(params, given, "refine").value_or(thesis ? 2 : 6 / component.spacing);
        component.rotation = rotation_of(params, given);
        if (given.has("variation")) {
            component.variation = variation_of(given);
            component.bend_place = given.record("variation").place("bend");
        }
    }
    return components;
}

} // namespace scree
