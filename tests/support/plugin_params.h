// SPDX-License-Identifier: GPL-3.0-or-later
// Calls plug-ins as the scene reader does, for tests.
#pragma once

#include "core/registry.h"

namespace scree::tests {

/// The defaults of all specs, located at line 7 of scene.lua.
inline Params defaults(const std::vector<ParamSpec>& specs, std::string path) {
    const Location where{"scene.lua", 7};
    Params params(std::move(path), where);
    for (const ParamSpec& spec : specs)
        params.set(spec.name, default_value(spec), where);
    return params;
}

/// Makes the object of the plug-in `name` from the given values and defaults, located at line 7 of
/// scene.lua.
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
