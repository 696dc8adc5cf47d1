// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "generators/elements/elements_generator.h"
#include "tests/support/plugin_params.h"

namespace scree::tests {

/// The first component of generator.elements, with the defaults but for its shape.
inline Params element_component(Value shape) {
    Params params;
    for (const ParamSpec& spec : elements_plugin().params)
        if (spec.name == "components")
            params = defaults(spec.fields, "generator.elements.components[1]");
    params.set("shape", std::move(shape), {"scene.lua", 20});
    return params;
}

inline Params elements_params(std::vector<Params> components) {
    Params params = defaults(elements_plugin().params, "generator.elements");
    params.set("components", std::make_shared<const std::vector<Params>>(std::move(components)));
    return params;
}

} // namespace scree::tests
