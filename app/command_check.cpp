// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.h"
#include "app/scene_options.h"
#include "app/standard_streams.h"
#include "core/text.h"
#include "core/utf8.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace scree {

namespace {

struct CheckOptions {
    SceneOptions scene;
    bool json = false;
};

// What rendering needs and baking does not.
void warn_of_missing(const SceneDraft& draft, const std::string& path, Console& console) {
    const auto warn = [&](const char* parameter, const char* problem, const char* hint) {
        const Diagnostic missing{{path, 0},
                                 parameter,
                                 std::string(problem) +
                                     ": scree bake can do without, scree render cannot",
                                 hint};
        console.warn(missing.text());
    };
    const std::vector<Light>& lights = draft.scene.lights;
    if (!draft.scene.camera)
        warn("scene.camera", "missing", "for example camera = camera.perspective {}");
    if (lights.empty())
        warn("scene.lights", "missing", "for example lights = { light.sky {}, light.sun {} }");
    else if (std::ranges::none_of(lights, gives_light))
        warn("scene.lights", "all black", "expected a strength and a color above 0");
}

int check(const CheckOptions& options) {
    SceneRun run(options.scene);
    const DescriptionNode description = run.session.description();
    const SceneDraft draft = run.session.check(description);
    warn_of_missing(draft, options.scene.path, run.console);
    if (options.json) {
        print_result(fmt::format("{}\n", to_json(*description)));
        return 0;
    }
    const auto generators = std::size_t(std::ranges::count_if(
        draft.items, [](const auto& item) { return item->kind != "object"; }));
    const Scene& scene = draft.scene;
    const std::size_t warned = run.console.warnings();
    if (!options.scene.quiet)
        print_result(visible(fmt::format(
            "{}: {}: {}, {}, {}, {} x {} pixels\n", scene.name,
            warned == 0 ? "no mistakes" : "no errors, " + counted(warned, "warning"),
            counted(generators, "generator"), counted(draft.items.size() - generators, "object"),
            counted(scene.lights.size(), "light"), scene.film.width, scene.film.height)));
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
