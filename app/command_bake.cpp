// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.h"
#include "app/layout_colors.h"
#include "app/load.h"
#include "app/run_stats.h"
#include "core/display_encoding.h"
#include "core/file.h"
#include "core/image.h"
#include "core/parallel.h"
#include "core/version.h"
#include "formats/bake_json.h"
#include "formats/layout_picture.h"

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
};

using WriteBake = std::function<void(const BakeOptions& options, const Scene& scene,
                                     std::span<const Aggregate> aggregates)>;

void bake_to_json(const BakeOptions& options, const Scene& scene,
                  std::span<const Aggregate> aggregates) {
    write_file(options.output, bake_json(aggregates, {scene.name, aggregates.front().seed}));
}

void bake_to_svg(const BakeOptions& options, const Scene& scene,
                 std::span<const Aggregate> aggregates) {
    write_file(options.output, layout_svg(aggregates, layout_colors(scene)));
}

void bake_to_png(const BakeOptions& options, const Scene& scene,
                 std::span<const Aggregate> aggregates) {
    write_png(options.output,
              display_image(layout_image(aggregates, layout_colors(scene), options.size)));
}

void bake_to_exr(const BakeOptions& options, const Scene& scene,
                 std::span<const Aggregate> aggregates) {
    const ImagePart part{"layout", layout_image(aggregates, layout_colors(scene), options.size)};
    const Box2 box = picture_box(aggregates);
    write_exr(
        options.output, {&part, 1},
        {{"scree:version", SCREE_VERSION},
         {"scree:scene", scene.name},
         {"scree:hash", fmt::format("{:016x}", scene.hash)},
         {"scree:settings", scene.settings}},
        {{"worldSize", {static_cast<float>(box.size().x), static_cast<float>(box.size().y)}}});
}

struct BakeFormat {
    std::string ending;
    WriteBake write;
};

const BakeFormat& format_for(const std::string& output) {
    static const std::vector<BakeFormat> formats{
        {"json", bake_to_json}, {"svg", bake_to_svg}, {"png", bake_to_png}, {"exr", bake_to_exr}};
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
    std::erase_if(aggregates, [](const Aggregate& a) { return a.generator == "object"; });
    if (aggregates.empty())
        throw Error(Diagnostic{{options.scene.path, 0},
                               "scene.objects",
                               "there is no generator to bake; expected a generator.*",
                               ""});

    stages.begin("write");
    format.write(options, scene, aggregates);
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
    command->add_option("-o,--output", options->output, "File to write: .json, .svg, .png or .exr")
        ->required();
    command->add_option("--size", options->size, "Pixels of the longer side of a .png or .exr")
        ->check(CLI::Range(16, 32768))
        ->type_name("PIXELS");
    command->add_option("--stats", options->stats, "Write counts, times and memory as JSON");
    command->footer("Example:\n  scree bake scenes/toys.lua -o toys.json --set seed=9");
    command->callback([options, &run] { run = [options] { return bake(*options); }; });
}

} // namespace scree
