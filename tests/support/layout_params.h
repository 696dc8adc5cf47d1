// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters of generator.layout as the scene reader makes them, for tests.
#pragma once

#include "generators/layout/layout_generator.h"
#include "tests/support/plugin_params.h"

namespace scree::tests {

inline Params component_defaults(std::size_t index) {
    const Plugin<Generator> plugin = layout_plugin();
    for (const ParamSpec& spec : plugin.params)
        if (spec.name == "components")
            return defaults(spec.fields,
                            "generator.layout.components[" + std::to_string(index + 1) + "]");
    return {};
}

inline Params component(std::size_t index, Value shape) {
    Params params = component_defaults(index);
    params.set("shape", std::move(shape), {"scene.lua", 20 + int(index)});
    return params;
}

inline Params layout_params(Value domain, std::vector<Params> components) {
    Params params = defaults(layout_plugin().params, "generator.layout");
    params.set("domain", std::move(domain), {"scene.lua", 9});
    params.set("components", std::make_shared<const std::vector<Params>>(std::move(components)),
               {"scene.lua", 10});
    return params;
}

} // namespace scree::tests
