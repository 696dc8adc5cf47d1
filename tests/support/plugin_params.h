// SPDX-License-Identifier: GPL-3.0-or-later
// A plug-in called as the scene reader would call it, for tests.
#pragma once

#include "core/registry.h"

namespace scree::tests {

/// All defaults of the specs, as if they stood in line 7 of scene.lua.
inline Params defaults(const std::vector<ParamSpec>& specs, std::string path) {
    const Location where{"scene.lua", 7};
    Params params(std::move(path), where);
    for (const ParamSpec& spec : specs)
        params.set(spec.name, default_value(spec), where);
    return params;
}

/// Makes what `name` of the table makes from these values and the defaults of the others, as if
/// they stood in line 7 of scene.lua.
template <class Make>
auto make(const Registry<Make>& table, const std::string& name,
          const std::map<std::string, Value>& values) {
    const Plugin<Make>* plugin = table.find(name);
    if (plugin == nullptr)
        throw std::logic_error("there is no " + table.family() + "." + name);
    Params params = defaults(plugin->params, table.family() + "." + name);
    for (const auto& [field, value] : values)
        params.set(field, value, params.where());
    return plugin->make(params);
}

} // namespace scree::tests
