// SPDX-License-Identifier: GPL-3.0-or-later
// Leathers and their parameters, for tests.
#pragma once

#include "generators/leather/leather_generator.h"
#include "generators/leather/relief.h"
#include "tests/support/plugin_params.h"

namespace scree::tests {

inline Params leather(const std::string& preset, int resolution = 256, double size = 0.04) {
    Params params = defaults(leather_plugin().params, "generator.leather");
    params.set("preset", preset, {"scene.lua", 3});
    params.set("resolution", std::int64_t{resolution}, {"scene.lua", 4});
    params.set("size", size, {"scene.lua", 5});
    params.set("triangles", std::int64_t{20000}, {"scene.lua", 6});
    return params;
}

inline ReliefRequest request(const LeatherSettings& settings, int resolution, double size = 0.03) {
    ReliefRequest r;
    r.settings = settings;
    r.size = size;
    r.resolution = resolution;
    r.seed = 5;
    return r;
}

inline const LeatherSettings& preset(const std::string& name) {
    for (const LeatherSettings& settings : leather_presets())
        if (settings.name == name)
            return settings;
    throw std::logic_error(name);
}

} // namespace scree::tests
