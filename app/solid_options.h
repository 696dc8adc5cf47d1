// SPDX-License-Identifier: GPL-3.0-or-later
// What `scree bake` needs to know for a solid.
#pragma once

#include "app/console.h"
#include "fabrication/fabricate.h"
#include "scenes/reader/scene.h"

namespace CLI {
class App;
}

namespace scree {

struct SolidOptions {
    double resolution = 0; // [m]; 0: by the thinnest component
    double bridge = 0;     // [m]
    std::string parts = "largest";
    std::string voids = "fill";
    std::string open = "error";

    void add_to(CLI::App& command);
};

/// The union of the aggregates' components, or the Error that names what stands in its way; each
/// aggregate was written at `places[i]` of the scene. Says what was made of it and what was left
/// out.
Fabrication make_solid(std::span<const Aggregate> aggregates, std::span<const Location> places,
                       const SolidOptions& options, Console& console, const Cancel& cancel);

} // namespace scree
