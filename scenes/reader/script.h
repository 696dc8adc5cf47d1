// SPDX-License-Identifier: GPL-3.0-or-later
// Scene scripts: Lua in a child process that can only build a description.
#pragma once

#include "scenes/reader/description.h"

#include <functional>
#include <string_view>

namespace scree {

/// What a script may use; generous for real scenes.
struct ScriptLimits {
    double seconds = 10;                         // of processor time
    std::size_t memory = std::size_t{512} << 20; // [bytes]
};

struct ScriptOptions {
    std::vector<std::string> families{};            // "mesh", ...: what constructors belong to
    std::map<std::string, std::string> overrides{}; // of --set, by name
    ScriptLimits limits{};
    std::function<void(std::string_view)> print{}; // gets what print(...) says; empty: stderr
};

/// Runs the script in a forked child and returns what it returned. The same script and overrides
/// give the same description. Throws Error (input) with file and line for mistakes of the script
/// and for crossed limits, Error (resource) when no child can be started.
DescriptionNode run_script(const std::string& path, const ScriptOptions& options);

} // namespace scree
