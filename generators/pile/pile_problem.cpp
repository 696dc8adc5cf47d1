// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/pile/pile_problem.h"

#include "generators/located.h"

#include <optional>

namespace scree {

namespace {

double thickness_of(const Params& component) {
    if (!component.flag("sheet")) {
        if (component.has("thickness"))
            throw component.error("thickness", "is given, but the component is no sheet",
                                  "expected sheet = true beside it");
        return 0;
    }
    return component.has("thickness") ? component.number("thickness")
                                      : 0.02 * 2 * std::sqrt(area(*component.mesh("shape")) / pi);
}

/// What is given for the component, or for all.
std::optional<double> given_number(const Params& params, const Params& component,
                                   const char* name) {
    for (const Params* from : {&component, &params})
        if (from->has(name))
            return from->number(name);
    return {};
}

const Params& given(const Params& params, const Params& component, const char* name) {
    return component.has(name) ? component : params;
}

} // namespace

std::vector<PileKind> pile_kinds(const Params& params) {
    const std::vector<Params>& components = params.list("components");
    const bool thesis = params.text("method") == "thesis";
    std::vector<PileKind> kinds;
    for (const Params& component : components) {
        Prototype prototype;
        prototype.mesh = component.mesh("shape");
        prototype.name = prototype.mesh->name;
        prototype.material = component.material("material");
        const double thickness = thickness_of(component);
        const double spacing = given_number(params, component, "spacing").value_or(thesis ? 1 : 3);
        kinds.push_back({
            .component =
                located(component, "shape",
                        [&] { return prepare_component(std::move(prototype), thickness); }),
            .weight = component.number("weight"),
            .spacing = spacing,
            .refine = given_number(params, component, "refine").value_or(thesis ? 2 : 6 / spacing),
            .rotation = given(params, component, "rotation").vector3("rotation"),
        });
    }
    return kinds;
}

} // namespace scree
