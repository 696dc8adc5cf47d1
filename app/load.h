// SPDX-License-Identifier: GPL-3.0-or-later
// From a scene's file name to its aggregates: what render, bake and check share.
#pragma once

#include "app/console.h"
#include "app/stages.h"
#include "scenes/reader/scene.h"

#include <map>
#include <optional>

namespace CLI {
class App;
}

namespace scree {

/// The options of every command that reads a scene.
struct SceneOptions {
    std::string path;
    std::vector<std::string> sets; // "seed=9"
    std::string device;
    int threads = 0;
    bool quiet = false;

    void add_to(CLI::App& command);
    std::map<std::string, std::string> overrides() const; // throws Error (usage) on "seed"
};

/// Reads and checks the scene (stage "parse").
Scene load_scene(const SceneOptions& options, Stages& stages);

/// Bakes every item of the scene (stage "generate").
std::vector<Aggregate> bake_scene(const Scene& scene, const SceneOptions& options, Stages& stages,
                                  Console& console, const Cancel& cancel);

/// "generate: layout 224 elements, fill 0.43" for the user.
std::string describe(const Aggregate& aggregate);

} // namespace scree
