// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.h"
#include "app/load.h"
#include "app/run_stats.h"
#include "core/file.h"
#include "core/parallel.h"
#include "formats/bake_json.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace scree {

namespace {

struct BakeOptions {
    SceneOptions scene;
    std::string output;
    std::string stats;
};

int bake(const BakeOptions& options) {
    const std::vector<std::string> formats{"json"};
    const std::string ending = extension(options.output);
    if (std::find(formats.begin(), formats.end(), ending) == formats.end())
        throw Error::usage(
            fmt::format("{}: cannot bake to .{}; expected .json", options.output, ending));
    check_writable(options.output);

    const ThreadLimit threads(options.scene.threads);
    Console console(options.scene.quiet);
    Cancel cancel;
    const InterruptGuard guard(cancel);
    Stages stages;
    const Scene scene = load_scene(options.scene, stages);
    std::vector<Aggregate> aggregates = bake_scene(scene, options.scene, stages, console, cancel);
    std::erase_if(aggregates, [](const Aggregate& a) { return a.generator == "object"; });
    if (aggregates.empty())
        throw Error(Diagnostic{{options.scene.path, 0},
                               "scene.objects",
                               "there is no generator to bake; expected a generator.*",
                               ""});

    stages.begin("write");
    write_file(options.output, bake_json(aggregates, {scene.name, aggregates.front().seed}));
    stages.end();
    console.say("wrote " + options.output);
    if (!options.stats.empty())
        write_file(options.stats, run_stats_json(stages, aggregates, nullptr));
    return 0;
}

} // namespace

void add_bake_command(CLI::App& app, Run& run) {
    auto options = std::make_shared<BakeOptions>();
    CLI::App* command =
        app.add_subcommand("bake", "Run a scene's generators and write their layout.");
    options->scene.add_to(*command);
    command->add_option("-o,--output", options->output, "File to write: .json")->required();
    command->add_option("--stats", options->stats, "Write counts, times and memory as JSON");
    command->footer("Example:\n  scree bake scenes/toys.lua -o toys.json --set seed=9");
    command->callback([options, &run] { run = [options] { return bake(*options); }; });
}

} // namespace scree
