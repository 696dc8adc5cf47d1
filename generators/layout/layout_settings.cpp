// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/layout/layout_settings.h"

#include <algorithm>

namespace scree {

namespace {

Inside inside_of(const Params& params) {
    if (params.flag("torus"))
        return Inside::torus;
    return params.text("inside") == "whole" ? Inside::whole : Inside::centre;
}

std::optional<LayoutMethod> method_of(const Params& params) {
    if (!params.has("method"))
        return {};
    const std::string& method = params.text("method");
    return method == "naive"       ? LayoutMethod::naive
           : method == "saturated" ? LayoutMethod::saturated
                                   : LayoutMethod::fill_gap;
}

Range rotation_of(const Params& params) {
    if (params.has("rotation"))
        return params.range("rotation");
    return params.has("direction") ? Range{0, 0} : Range{0, 2 * pi};
}

LayoutComponent component_from(const Params& params, std::size_t index) {
    return {.mesh = params.object<Mesh>("shape"),
            .flat_shape = params.object<Region>("shape"),
            .given_region = params.object<Region>("region"),
            .materials = materials_of(params, params.object<Mesh>("shape").get()),
            .weight = params.number("weight"),
            .margin = params.number("margin"),
            .class_number = params.has("class") ? static_cast<long>(params.integer("class"))
                                                : static_cast<long>(index) + 1,
            .height = params.number("height"),
            .shape_place = params.place("shape"),
            .region_place = params.place(params.has("region") ? "region" : "shape"),
            .margin_place = params.place("margin")};
}

/// Components of different weights are selected by weight unless the script says otherwise.
Selection selection_of(const Params& params, const std::vector<LayoutComponent>& components) {
    if (params.has("selection"))
        return params.text("selection") == "cyclic" ? Selection::cyclic : Selection::weighted;
    const bool weights_differ =
        std::any_of(components.begin(), components.end(),
                    [&](const auto& c) { return c.weight != components.front().weight; });
    return weights_differ ? Selection::weighted : Selection::cyclic;
}

} // namespace

LayoutSettings layout_settings(const Params& params) {
    LayoutSettings settings;
    settings.method = method_of(params);
    settings.domain = params.object<Region>("domain");
    settings.inside = inside_of(params);
    for (const Params& component : params.list("components"))
        settings.components.push_back(component_from(component, settings.components.size()));
    settings.selection = selection_of(params, settings.components);
    settings.fields = {field_of(params, "direction"), field_of(params, "scale_by"),
                       field_of(params, "density"), field_of(params, "classes")};
    settings.rotation = rotation_of(params);
    settings.scale = params.range("scale");
    settings.seed = static_cast<std::uint64_t>(params.integer("seed"));
    if (params.has("max_count"))
        settings.max_count = static_cast<std::size_t>(params.integer("max_count"));
    settings.fill_gap.candidates = static_cast<std::size_t>(params.integer("candidates"));
    settings.fill_gap.exponent = static_cast<std::uint32_t>(params.integer("exponent"));
    settings.fill_gap.resolution = static_cast<int>(params.integer("resolution"));
    settings.counts_darts = params.has("cancellations");
    if (settings.counts_darts)
        settings.fill_gap.cancellations = settings.naive_cancellations =
            static_cast<std::uint64_t>(params.integer("cancellations"));
    settings.epsilon_share = params.number("epsilon");
    settings.domain_place = params.place("domain");
    settings.torus_place = params.place("torus");
    settings.components_place = params.place("components");
    settings.epsilon_place = params.place("epsilon");
    return settings;
}

} // namespace scree
