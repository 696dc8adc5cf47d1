// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/plot_sheet.h"
#include "app/commands.h"
#include "app/file_option.h"
#include "app/scene_options.h"
#include "core/file.h"
#include "formats/read_bake_json.h"
#include "session/analysis_json.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace scree {

namespace {

struct AnalyseOptions {
    SceneOptions scene;
    std::string output = "report.json";
    int seeds = 1;
};

// For each seed, the aggregates that have a domain.
using Runs = std::vector<std::vector<Aggregate>>;

std::vector<Aggregate> with_domain(std::vector<Aggregate> aggregates) {
    std::erase_if(aggregates, [](const Aggregate& a) { return a.domain == nullptr; });
    return aggregates;
}

Runs bake_seeds(const AnalyseOptions& options, SceneRun& run) {
    Runs runs;
    SessionOptions scene = options.scene.session();
    for (int i = 0; i < options.seeds; ++i) {
        Session session(scene, run.console, interruption());
        runs.push_back(with_domain(session.bake(session.load()).aggregates));
        if (runs[0].empty())
            break;
        scene.overrides["seed"] = fmt::format("{}", runs[0][0].seed + std::uint64_t(i) + 1);
    }
    return runs;
}

Runs runs_of(const AnalyseOptions& options, SceneRun& run) {
    if (extension(options.scene.path) == "json") {
        const std::string text = read_file(options.scene.path);
        if (is_bake_json(text)) {
            if (options.seeds > 1)
                throw Error::usage("--seeds needs a scene: " + options.scene.path +
                                   " holds one layout");
            return {with_domain(read_bake_json(text, options.scene.path))};
        }
    }
    return bake_seeds(options, run);
}

// "report.png" for index 0, then "report-2.png".
std::string sheet_name(const std::string& output, std::size_t index) {
    const std::string stem = output.substr(0, output.size() - extension(output).size() - 1);
    return index == 0 ? stem + ".png" : fmt::format("{}-{}.png", stem, index + 1);
}

int run_analyse(const AnalyseOptions& options) {
    if (extension(options.output) != "json")
        throw Error::usage(options.output + ": expected a name that ends in .json");
    check_writable(options.output);
    check_writable(sheet_name(options.output, 0));
    SceneRun run(options.scene);
    const Runs runs = runs_of(options, run);
    if (runs[0].empty())
        throw Error(Diagnostic{{options.scene.path, 0},
                               "",
                               "there is nothing to analyse; expected a generator with a domain",
                               ""});

    std::vector<NamedReport> reports;
    for (std::size_t g = 0; g < runs[0].size(); ++g) {
        std::vector<PlacedRegions> layouts;
        std::vector<std::uint64_t> seeds;
        for (const std::vector<Aggregate>& baked : runs) {
            layouts.push_back(placed_regions(baked[g]));
            seeds.push_back(baked[g].seed);
        }
        interruption().check();
        reports.push_back({runs[0][g].generator, runs[0][g].name, analyse(layouts, seeds)});
        const std::string sheet = sheet_name(options.output, g);
        write_png(sheet, plot_sheet(reports.back().report, layouts[0],
                                    file_name(options.scene.path) + ": " + title(runs[0][g])));
        run.console.say("wrote " + sheet);
    }
    write_file(options.output, analysis_json(reports, file_name(options.scene.path)));
    run.console.say("wrote " + options.output);
    return 0;
}

} // namespace

void add_analyse_command(CLI::App& app, Run& run) {
    auto options = std::make_shared<AnalyseOptions>();
    CLI::App* command = app.add_subcommand(
        "analyse", "Measure a layout: fill, gaps, pair correlation, power spectrum.");
    options->scene.add_to(*command);
    command->get_option("SCENE")->description("Scene (.lua, .json) or baked layout (.json)");
    add_file_option(*command, "-o,--output", options->output,
                    "File to write: .json, and plots of the same name as .png");
    command
        ->add_option(
            "--seeds", options->seeds,
            "Average over this many seeds from the scene's own; it needs arg(\"seed\", ...)")
        ->check(CLI::Range(1, 10000))
        ->type_name("N");
    command->footer("Example:\n  scree analyse scenes/toys.lua -o report.json --seeds 10");
    command->callback([options, &run] { run = [options] { return run_analyse(*options); }; });
}

} // namespace scree
