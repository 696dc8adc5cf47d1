// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.h"
#include "app/file_option.h"
#include "app/number_checks.h"
#include "app/scene_options.h"
#include "core/file.h"
#include "formats/table.h"
#include "session/export_scene.h"
#include "session/run_stats.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace scree {

namespace {

struct BakeOptions {
    SceneOptions scene;
    std::string output;
    std::string stats;
    LayoutLook look;
    double resolution = 0; // [m]
    double bridge = 0;     // [m]
    std::string parts = "largest";
    std::string voids = "fill";
    std::string open = "error";

    void add_solid_options(CLI::App& command);
    SolidOptions solid() const;
};

void BakeOptions::add_solid_options(CLI::App& command) {
    const CLI::AsNumberWithUnit metres(
        std::map<std::string, double>{{"m", 1}, {"cm", 0.01}, {"mm", 0.001}, {"um", 1e-6}});
    const std::string group = "For .stl and .3mf";
    command
        .add_option("--resolution", resolution,
                    "Side of the lattice's cells, in metres or as in 0.2mm; a tenth of the "
                    "thinnest component by default")
        ->transform(metres)
        ->type_name("LENGTH")
        ->group(group);
    command
        .add_option("--bridge", bridge,
                    "Close gaps narrower than twice this, in metres or as in 0.5mm")
        ->transform(metres)
        ->type_name("LENGTH")
        ->group(group);
    command
        .add_option("--parts", parts,
                    "Of parts that are not connected: keep the largest, or keep all")
        ->check(CLI::IsMember({"largest", "keep"}))
        ->group(group);
    command.add_option("--voids", voids, "Enclosed voids: fill or keep them")
        ->check(CLI::IsMember({"fill", "keep"}))
        ->group(group);
    command
        .add_option("--open", open,
                    "Components that are not closed: stop with an error, or skip them")
        ->check(CLI::IsMember({"error", "skip"}))
        ->group(group);
}

void check_length(const std::string& option, double length) {
    if (!(length >= 0) || length > 1e6)
        throw Error::usage(fmt::format("{} {}: expected 0 to 1e6 metres", option, length));
}

SolidOptions BakeOptions::solid() const {
    check_length("--resolution", resolution);
    check_length("--bridge", bridge);
    SolidOptions out;
    out.fabrication.resolution = resolution;
    out.fabrication.bridge = bridge;
    out.fabrication.keep_parts = parts == "keep";
    out.fabrication.keep_voids = voids == "keep";
    out.skip_open = open == "skip";
    return out;
}

int bake(const BakeOptions& options) {
    const SceneFormat format = scene_format(scene_formats(), options.output);
    const SolidOptions solid = options.solid();
    check_writable(options.output);
    if (!options.stats.empty())
        check_writable(options.stats);
    SceneRun run(options.scene);
    const Exported exported = export_scene(run.session, run.session.bake(run.session.load()),
                                           format, options.output, options.look, solid);
    if (!options.stats.empty())
        write_file(options.stats,
                   run_stats_json(run.session.stages(), exported.scene.aggregates, nullptr, {},
                                  exported.solid ? &*exported.solid : nullptr));
    return 0;
}

} // namespace

void add_bake_command(CLI::App& app, Run& run) {
    auto options = std::make_shared<BakeOptions>();
    CLI::App* command =
        app.add_subcommand("bake", "Run a scene's generators and write what they made.");
    options->scene.add_to(*command);
    add_file_option(*command, "-o,--output", options->output,
                    "File to write: .json, .svg, .png, .exr, .stl or .3mf")
        ->required();
    command
        ->add_option("--size", options->look.pixels,
                     "Pixels of the longer side of a .png or .exr; 1600 by default")
        ->check(problem_of_size)
        ->type_name("PIXELS");
    command
        ->add_option_function<std::string>(
            "--margins",
            [options](const std::string& what) { options->look.margins = what == "draw"; },
            "Outlines of margins in a .svg, .png or .exr: draw (the default) or hide them")
        ->check(CLI::IsMember({"draw", "hide"}));
    add_stats_option(*command, options->stats);
    options->add_solid_options(*command);
    command->footer("Example:\n  scree bake scenes/toys.lua -o toys.json --set seed=9\n"
                    "  scree bake heap.lua -o heap.3mf --resolution 0.2mm --bridge 0.3mm\n"
                    "For .stl and .3mf, which are in millimetres with z up, all components are "
                    "united to one\nclosed surface.");
    command->callback([options, &run] { run = [options] { return bake(*options); }; });
}

} // namespace scree
