// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.h"
#include "app/file_option.h"
#include "app/object_option.h"
#include "app/picture_output.h"
#include "app/scene_options.h"
#include "core/file.h"
#include "core/text.h"
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
    std::string object; // its number or name; empty: see index
    int index = 0;      // 1-based, among the maps; 0: the only one
    bool vector = false;
};

bool makes_height(const SceneItem& item) { return item.kind == "leather"; }

/// The number of the item whose height map is requested, counted from 1. Throws Error when there is
/// none, when the index is too large, and when there are several and none is chosen.
int chosen_map(const SceneDraft& draft, const HeightOptions& options) {
    if (!options.object.empty()) {
        const int object = chosen_object(options.object, options.scene.path, draft);
        const SceneItem& item = *draft.items[std::size_t(object - 1)];
        if (!makes_height(item))
            throw Error(Diagnostic{item.where,
                                   item.kind == "object" ? "object" : "generator." + item.kind,
                                   "has no height map; expected a generator.leather", ""});
        return object;
    }
    std::vector<int> maps;
    for (std::size_t i = 0; i < draft.items.size(); ++i)
        if (makes_height(*draft.items[i]))
            maps.push_back(static_cast<int>(i) + 1);
    if (maps.empty())
        throw Error(Diagnostic{{options.scene.path, 0},
                               "scene.objects",
                               "no generator has a height map; expected a generator.leather",
                               ""});
    const auto count = static_cast<int>(maps.size());
    if (options.index == 0 && count > 1)
        throw Error::usage(
            fmt::format("{} has {} height maps; choose one", options.scene.path, count),
            "for example --index 1, counted in the order of scene.objects, or --object NAME");
    if (options.index > count)
        throw Error::usage(fmt::format("--index {}: {} has {}", options.index, options.scene.path,
                                       counted(maps.size(), "height map")));
    return maps[std::size_t(options.index == 0 ? 0 : options.index - 1)];
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
    SceneDraft draft = run.session.load();
    const int chosen = chosen_map(draft, options);
    make_only(chosen, draft);
    const Scene scene = run.session.bake(std::move(draft));
    const Aggregate& aggregate = scene.aggregates[std::size_t(chosen - 1)];

    run.session.stages().begin("write");
    const HeightField heights = aggregate.height->as_height();
    const HeightField map = options.vector ? aggregate.height->as_vector() : heights;
    if (aggregate.height->is_vector() && !options.vector)
        run.console.warn("the relief overhangs, and heights alone do not hold that\n"
                         "  --vector writes it whole");
    Metadata metadata = provenance(scene);
    metadata.insert(metadata.end(), {{"scree:generator", aggregate.generator},
                                     {"scree:seed", std::to_string(aggregate.seed)}});
    write_height(options.output, map, metadata);
    const std::string png = beside(options.output, "png");
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
    add_file_option(*command, "-o,--output", options->output,
                    "File to write: .exr, in metres; a .png to look at beside it")
        ->required();
    command->add_flag("--vector", options->vector,
                      "Write the offset along x, y and z as R, G and B in place of the height");
    CLI::Option* index =
        command
            ->add_option("--index", options->index,
                         "Which map, counted from 1, when several generators make one; the others "
                         "are not made")
            ->check(CLI::Range(1, 1 << 20))
            ->type_name("N");
    command
        ->add_option("--object", options->object,
                     "The same by the generator's name, or its number in scene.objects")
        ->type_name("N|NAME")
        ->excludes(index);
    add_stats_option(*command, options->stats);
    command->footer("Example:\n  scree height scenes/leather.lua -o leather.exr --index 2");
    command->callback([options, &run] { run = [options] { return write_map(*options); }; });
}

} // namespace scree
