// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.h"
#include "app/load.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace scree {

namespace {

struct CheckOptions {
    SceneOptions scene;
    bool json = false;
};

int check(const CheckOptions& options) {
    const DescriptionNode description =
        read_description(options.scene.path, options.scene.overrides());
    const Scene scene = resolve(description, options.scene.path);
    if (options.json) {
        fmt::print("{}\n", to_json(*description));
        return 0;
    }
    std::size_t generators = 0;
    for (const SceneItem& item : scene.items)
        generators += item.kind == "object" ? 0 : 1;
    if (!options.scene.quiet)
        fmt::print(
            "{}: no mistakes: {} generators, {} objects, {} materials, {} lights, {} x {} pixels\n",
            scene.name, generators, scene.items.size() - generators, scene.materials.size() - 1,
            scene.lights.size(), scene.film.width, scene.film.height);
    return 0;
}

} // namespace

void add_check_command(CLI::App& app, Run& run) {
    auto options = std::make_shared<CheckOptions>();
    CLI::App* command =
        app.add_subcommand("check", "Look for mistakes in a scene without rendering it.");
    options->scene.add_to(*command);
    command->add_flag("--json", options->json,
                      "Print the scene as JSON, which every command reads too");
    command->footer("Example:\n  scree check scenes/toys.lua --json > toys.json");
    command->callback([options, &run] { run = [options] { return check(*options); }; });
}

} // namespace scree
