// SPDX-License-Identifier: GPL-3.0-or-later
// Runs scene scripts: Lua in a child process that can only build a description.
#pragma once

#include "scenes/reader/description.h"

#include <functional>
#include <string_view>

namespace scree {

/// Resource limits of a script, far above the needs of usual scenes.
struct ScriptLimits {
    double seconds = 5;                          // of processor time
    std::size_t memory = std::size_t{512} << 20; // [bytes]
};

struct ScriptOptions {
    std::vector<std::string> families{};            // of the constructors: "mesh", ...
    std::map<std::string, std::string> overrides{}; // of --set, by name
    std::vector<std::string> readable_folders{};    // beside the script's own, for include(...)
    ScriptLimits limits{};
    std::function<void(std::string_view)>
        print{}; // receives the output of print(...); empty: stderr
};

/// Runs the script in a forked child and returns its result. Deterministic: equal scripts and
/// overrides give equal descriptions. Throws Error (input) with file and line for errors in the
/// script and exceeded limits, Error (resource) when no child can be started.
DescriptionNode run_script(const std::string& path, const ScriptOptions& options);

} // namespace scree
