// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "procedurals/solid/cells/grains_specs.h"

namespace scree {

/// A commercial polished granite, with real dimensions.
struct GranitePreset {
    std::string name;
    GrainRecipe grains;
    double turbulence = 2.5;
};

const std::vector<GranitePreset>& granite_presets();

} // namespace scree
