// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.h"
#include "app/layout_colors.h"
#include "app/load.h"
#include "app/run_stats.h"
#include "app/solid_options.h"
#include "core/display_encoding.h"
#include "core/file.h"
#include "core/image.h"
#include "core/parallel.h"
#include "core/version.h"
#include "formats/bake_json.h"
#include "formats/layout_picture.h"
#include "formats/write_3mf.h"
#include "formats/write_stl.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <functional>
#include <memory>

namespace scree {

namespace {

struct BakeOptions {
    SceneOptions scene;
    std::string output;
    std::string stats;
    int size = 1600;
    SolidOptions solid;
};

/// One run of the command.
struct BakeJob {
    const BakeOptions& options;
    const Scene& scene;
    std::vector<Aggregate> aggregates; // of generators
    std::vector<Location> places;      // where they were written
    Console& console;
    const Cancel& cancel;
    Stages& stages;
    std::optional<Fabrication> solid{}; // once made
};

using WriteBake = std::function<void(BakeJob& job)>;

void bake_to_json(BakeJob& job) {
    write_file(job.options.output,
               bake_json(job.aggregates, {job.scene.name, job.aggregates.front().seed}));
}

void bake_to_svg(BakeJob& job) {
    write_file(job.options.output, layout_svg(job.aggregates, layout_colors(job.scene)));
}

void bake_to_png(BakeJob& job) {
    write_png(job.options.output, display_image(layout_image(
                                      job.aggregates, layout_colors(job.scene), job.options.size)));
}

void bake_to_exr(BakeJob& job) {
    const ImagePart part{"layout",
                         layout_image(job.aggregates, layout_colors(job.scene), job.options.size)};
    const Box2 box = picture_box(job.aggregates);
    write_exr(
        job.options.output, {&part, 1},
        {{"scree:version", SCREE_VERSION},
         {"scree:scene", job.scene.name},
         {"scree:hash", fmt::format("{:016x}", job.scene.hash)},
         {"scree:settings", job.scene.settings}},
        {{"worldSize", {static_cast<float>(box.size().x), static_cast<float>(box.size().y)}}});
}

void bake_to_stl(BakeJob& job) { write_stl(job.options.output, job.solid->mesh); }

void bake_to_3mf(BakeJob& job) { write_3mf(job.options.output, job.solid->mesh, job.scene.name); }

struct BakeFormat {
    std::string ending;
    WriteBake write;
    bool solid = false; // holds the union of all components
};

const BakeFormat& format_for(const std::string& output) {
    static const std::vector<BakeFormat> formats{
        {"json", bake_to_json}, {"svg", bake_to_svg},       {"png", bake_to_png},
        {"exr", bake_to_exr},   {"stl", bake_to_stl, true}, {"3mf", bake_to_3mf, true}};
    const std::string ending = extension(output);
    std::vector<std::string> known;
    for (const BakeFormat& format : formats) {
        if (format.ending == ending)
            return format;
        known.push_back("." + format.ending);
    }
    throw Error::usage(fmt::format("{}: cannot bake to .{}; expected one of {}", output, ending,
                                   fmt::join(known, ", ")));
}

int bake(const BakeOptions& options) {
    const BakeFormat& format = format_for(options.output);
    check_writable(options.output);

    const ThreadLimit threads(options.scene.threads);
    Console console(options.scene.quiet);
    Cancel cancel;
    const InterruptGuard guard(cancel);
    Stages stages;
    const Scene scene = load_scene(options.scene, stages);
    std::vector<Aggregate> aggregates = bake_scene(scene, options.scene, stages, console, cancel);
    BakeJob job{options, scene, {}, {}, console, cancel, stages};
    for (std::size_t i = 0; i < aggregates.size(); ++i)
        if (aggregates[i].generator != "object") {
            job.aggregates.push_back(std::move(aggregates[i]));
            job.places.push_back(scene.items[i].where);
        }
    if (job.aggregates.empty())
        throw Error(Diagnostic{{options.scene.path, 0},
                               "scene.objects",
                               "there is no generator to bake; expected a generator.*",
                               ""});

    if (format.solid) {
        stages.begin("solid");
        job.solid = make_solid(job.aggregates, job.places, options.solid, console, cancel);
    }
    stages.begin("write");
    format.write(job);
    stages.end();
    console.say("wrote " + options.output);
    if (!options.stats.empty())
        write_file(options.stats, run_stats_json(stages, job.aggregates, nullptr, {},
                                                 job.solid ? &*job.solid : nullptr));
    return 0;
}

} // namespace

void add_bake_command(CLI::App& app, Run& run) {
    auto options = std::make_shared<BakeOptions>();
    CLI::App* command =
        app.add_subcommand("bake", "Run a scene's generators and write what they made.");
    options->scene.add_to(*command);
    command
        ->add_option("-o,--output", options->output,
                     "File to write: .json, .svg, .png, .exr, .stl or .3mf")
        ->required();
    command->add_option("--size", options->size, "Pixels of the longer side of a .png or .exr")
        ->check(CLI::Range(16, 32768))
        ->type_name("PIXELS");
    command->add_option("--stats", options->stats, "Write counts, times and memory as JSON");
    options->solid.add_to(*command);
    command->footer("Example:\n  scree bake scenes/toys.lua -o toys.json --set seed=9\n"
                    "  scree bake heap.lua -o heap.3mf --resolution 0.2mm --bridge 0.3mm\n"
                    "For .stl and .3mf, which are in millimetres with z up, all components are "
                    "united to one\nclosed surface.");
    command->callback([options, &run] { run = [options] { return bake(*options); }; });
}

} // namespace scree
