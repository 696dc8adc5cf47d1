// SPDX-License-Identifier: GPL-3.0-or-later
// Shared by all commands that read a scene.
#pragma once

#include "app/console.h"
#include "app/interruption.h"
#include "session/session.h"

namespace CLI {
class App;
}

namespace scree {

/// The options of every command that reads a scene.
struct SceneOptions {
    std::string path;
    std::vector<std::string> sets; // "seed=9"
    std::vector<std::string> readable_folders;
    std::string device;
    int threads = 0;
    bool quiet = false;

    void add_to(CLI::App& command);
    SessionOptions session() const; // throws Error (usage) when a --set is not name=value
};

/// The objects that one run of such a command needs.
struct SceneRun {
    explicit SceneRun(const SceneOptions& options)
        : console(options.quiet), session(options.session(), console, interruption()) {}

    Console console;
    Session session;
};

} // namespace scree
