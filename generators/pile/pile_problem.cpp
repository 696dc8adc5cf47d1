// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/pile/pile_problem.h"

#include "core/located.h"
#include "core/parallel.h"
#include "generators/pile/shape_variation.h"

#include <fmt/format.h>

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
    return component.has("thickness")
               ? component.number("thickness")
               : 0.02 * 2 * std::sqrt(area(*component.object<Mesh>("shape")) / pi);
}

/// What is given for the component, or for all.
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

std::vector<Prototype> prototypes_of(const Params& component, std::uint64_t seed) {
    Prototype prototype;
    prototype.shape = component.object<Mesh>("shape");
    prototype.name = prototype.mesh()->name;
    prototype.material = component.object<Material>("material");
    if (!component.has("variation"))
        return {prototype};
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
    std::vector<Prototype> shapes(variation.shapes, prototype);
    for (std::uint32_t i = 0; i < variation.shapes; ++i) {
        shapes[i].shape = std::make_shared<const Mesh>(located(
            given, "bend", [&] { return varied_shape(*prototype.mesh(), variation, seed, i); }));
        shapes[i].name = fmt::format("{}_{}", prototype.name, i + 1);
    }
    return shapes;
}

} // namespace

PileKinds::PileKinds(const Params& params) {
    const std::vector<Params>& components = params.list("components");
    const bool thesis = params.text("method") == "thesis";
    const auto seed = static_cast<std::uint64_t>(params.integer("seed"));
    for (const Params& component : components) {
        const double thickness = thickness_of(component);
        const double spacing = given_number(params, component, "spacing").value_or(thesis ? 1 : 3);
        std::vector<Prototype> shapes = prototypes_of(component, seed + kinds.size());
        const std::size_t first = kinds.size();
        kinds.resize(first + shapes.size());
        completions.resize(kinds.size());
        parallel_for(shapes.size(), 1, [&](std::size_t i) {
            ComponentDraft draft = located(component, "shape", [&] {
                return draft_component(std::move(shapes[i]), thickness);
            });
            completions[first + i] = std::move(draft.complete);
            kinds[first + i] = {
                .component = std::move(draft.component),
                .weight = i == 0 ? component.number("weight") : 0,
                .shapes = i == 0 ? static_cast<std::uint32_t>(shapes.size()) : 0,
                .spacing = spacing,
                .refine =
                    given_number(params, component, "refine").value_or(thesis ? 2 : 6 / spacing),
                .rotation = rotation_of(params, component),
            };
        });
    }
}

} // namespace scree
