// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.h"
#include "app/scene_options.h"
#include "core/file.h"
#include "session/run_stats.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace scree {

namespace {

struct HeightOptions {
    SceneOptions scene;
    std::string output;
    std::string stats;
    int index = 0; // 1-based; 0: the only one
    bool vector = false;
};

/// The aggregate whose height map is requested. Throws Error when there is none, when the index is
/// too large, and when there are several and no index is given.
const Aggregate& chosen(const std::vector<Aggregate>& aggregates, const HeightOptions& options) {
    std::vector<const Aggregate*> maps;
    for (const Aggregate& aggregate : aggregates)
        if (aggregate.height)
            maps.push_back(&aggregate);
    if (maps.empty())
        throw Error(Diagnostic{{options.scene.path, 0},
                               "scene.objects",
                               "no generator has a height map; expected a generator.leather",
                               ""});
    const auto count = static_cast<int>(maps.size());
    if (options.index == 0 && count > 1)
        throw Error::usage(
            fmt::format("{} has {} height maps; choose one", options.scene.path, count),
            "for example --index 1, counted in the order of scene.objects");
    if (options.index > count)
        throw Error::usage(fmt::format("--index {}: {} has {} height map{}", options.index,
                                       options.scene.path, count, count == 1 ? "" : "s"));
    return *maps[std::size_t(options.index == 0 ? 0 : options.index - 1)];
}

/// The heights as a grey picture, the lowest black and the highest white.
Image picture_of(Image picture, float low, float high) {
    for (float& v : picture.pixels)
        v = high > low ? (v - low) / (high - low) : 0.5F;
    return picture;
}

int write_map(const HeightOptions& options) {
    if (extension(options.output) != "exr")
        throw Error::usage(options.output + ": expected a name that ends in .exr");
    check_writable(options.output);
    if (!options.stats.empty())
        check_writable(options.stats);

    SceneRun run(options.scene);
    const Scene scene = run.session.bake(run.session.load());
    const Aggregate& aggregate = chosen(scene.aggregates, options);

    run.session.stages().begin("write");
    const HeightField heights = aggregate.height->as_height();
    const HeightField map = options.vector ? aggregate.height->as_vector() : heights;
    Metadata metadata = provenance(scene);
    metadata.insert(metadata.end(), {{"scree:generator", aggregate.generator},
                                     {"scree:seed", std::to_string(aggregate.seed)}});
    write_height(options.output, map, metadata);
    const std::string png = options.output.substr(0, options.output.size() - 3) + "png";
    const std::vector<float>& values = heights.image.pixels;
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    write_png(png, picture_of(heights.image, *low, *high));
    run.session.stages().end();
    run.console.say(
        fmt::format("wrote {} and {}: {} x {} pixels over {:.4g} x {:.4g} mm, heights from "
                    "{:.3g} mm (black) to {:.3g} mm (white)",
                    options.output, png, map.image.width, map.image.height, map.size.x * 1e3,
                    map.size.y * 1e3, double(*low) * 1e3, double(*high) * 1e3));
    if (!options.stats.empty())
        write_file(options.stats, run_stats_json(run.session.stages(), scene.aggregates, nullptr));
    return 0;
}

} // namespace

void add_height_command(CLI::App& app, Run& run) {
    auto options = std::make_shared<HeightOptions>();
    CLI::App* command = app.add_subcommand(
        "height", "Write the height map that a scene's generator makes, with a .png beside it.");
    options->scene.add_to(*command);
    command->add_option("-o,--output", options->output, "File to write: .exr, in metres")
        ->required();
    command->add_flag("--vector", options->vector,
                      "Write the offset along x, y and z as R, G and B in place of the height");
    command
        ->add_option("--index", options->index,
                     "Which map, counted from 1, when several generators make one")
        ->check(CLI::Range(1, 1 << 20));
    command->add_option("--stats", options->stats, "Write counts, times and memory as JSON");
    command->footer("Example:\n  scree height scenes/leather.lua -o leather.exr --index 2");
    command->callback([options, &run] { run = [options] { return write_map(*options); }; });
}

} // namespace scree
