// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/elements/elements_settings.h"

#include "core/image_params.h"

namespace scree {

namespace {

void check_shape(const Params& component) {
    const bool has_shape = component.has("shape");
    if (has_shape && component.has("picture"))
        throw component.error("shape", "is given beside a picture; one of them will do");
    if (!has_shape && !component.has("picture"))
        throw component.error("shape", "is missing, and there is no picture either",
                              "expected a mesh.* or region.*, or picture = a path");
}

Range turn_of(const Params& params, const Params& component) {
    if (component.has("rotation"))
        return component.range("rotation");
    if (params.has("rotation"))
        return params.range("rotation");
    return params.has("surface") ? Range{0, 2 * pi} : Range{0, 0};
}

std::optional<double> optional_number(const Params& params, const std::string& name) {
    return params.has(name) ? std::optional(params.number(name)) : std::nullopt;
}

ElementComponent component_from(const Params& params, const Params& component) {
    check_shape(component);
    return {.mesh = component.object<Mesh>("shape"),
            .flat_shape = component.object<Region>("shape"),
            .picture =
                component.has("picture") ? std::optional(picture_shape(component)) : std::nullopt,
            .given_region = component.object<Region>("region"),
            .materials = materials_of(component, component.object<Mesh>("shape").get()),
            .weight = component.number("weight"),
            .length = optional_number(component, "length"),
            .width = optional_number(component, "width"),
            .margin = component.number("margin"),
            .height = component.number("height"),
            .turn = turn_of(params, component),
            .shape_place = component.place("shape"),
            .region_place = component.place(component.has("region") ? "region" : "shape"),
            .margin_place = component.place("margin"),
            .length_place = component.place("length"),
            .rotation_place = component.place("rotation")};
}

void check_domain(const Params& params) {
    if (params.has("domain") && params.has("surface"))
        throw params.error("surface", "is given beside a domain; one of them will do");
    if (!params.has("domain") && !params.has("surface"))
        throw params.error("domain", "is missing, and there is no surface either",
                           "expected a region.*, or surface = a mesh.*");
}

} // namespace

ElementsSettings elements_settings(const Params& params) {
    check_domain(params);
    ElementsSettings settings;
    settings.domain = params.object<Region>("domain");
    settings.surface = params.object<Mesh>("surface");
    settings.torus = params.flag("torus");
    for (const Params& component : params.list("components"))
        settings.components.push_back(component_from(params, component));
    settings.mix = params.text("mix") == "even" ? ElementMix::even : ElementMix::random;
    settings.are_disks = params.text("exclusion") == "disk" || params.has("surface");
    settings.whole_inside = params.text("inside") == "whole";
    settings.direction = field_of(params, "direction");
    settings.scale = field_of(params, "scale_by");
    settings.spacing = field_of(params, "spacing_by");
    settings.relax = static_cast<int>(params.integer("relax"));
    if (params.has("background"))
        settings.background = params.text("background");
    settings.background_options = image_options(params, "background");
    settings.seed = static_cast<std::uint64_t>(params.integer("seed"));
    settings.domain_place = params.place("domain");
    settings.surface_place = params.place("surface");
    settings.torus_place = params.place("torus");
    settings.components_place = params.place("components");
    settings.direction_place = params.place("direction");
    settings.scale_place = params.place("scale_by");
    settings.spacing_place = params.place("spacing_by");
    settings.relax_place = params.place("relax");
    settings.background_place = params.place("background");
    return settings;
}

} // namespace scree
