// SPDX-License-Identifier: GPL-3.0-or-later
// What all commands that work on a scene have in common.
#pragma once

#include "app/console.h"
#include "session/session.h"

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
    SessionOptions session() const; // throws Error (usage) on a --set that is no name=value
};

/// What one run of such a command works with. Ctrl-C requests its `cancel`.
struct SceneRun {
    explicit SceneRun(const SceneOptions& options)
        : console(options.quiet), guard(cancel), session(options.session(), console, cancel) {}

    Console console;
    Cancel cancel;
    InterruptGuard guard;
    Session session;
};

} // namespace scree
