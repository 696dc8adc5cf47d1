// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.h"
#include "app/file_option.h"
#include "app/number_checks.h"
#include "app/picture_output.h"
#include "app/scene_options.h"
#include "core/text.h"
#include "render/film/denoise.h"
#include "session/cryptomatte.h"
#include "session/merge_shards.h"
#include "session/render_scene.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>

namespace scree {

namespace {

const std::array<std::string, 9> aov_names{"albedo",
                                           "N",
                                           "Z",
                                           "P",
                                           "instance",
                                           "variance",
                                           std::string(cryptomatte_layers[0]),
                                           std::string(cryptomatte_layers[1]),
                                           std::string(cryptomatte_layers[2])};

struct RenderCommand {
    SceneOptions scene;
    std::string output;
    std::string stats;
    std::string size;
    std::string crop;
    std::vector<std::string> aovs;
    PngLook look; // its exposure is the scene's
    std::string shard;
    int samples = 0;
    double time_limit = 0;
    double noise = 0;
    std::uint64_t seed = 0;
    bool resume = false;
    bool preview = false;
    bool denoise = false;
    bool partial = false;
};

constexpr double preview_every = 3; // [s]

void parse_size(const std::string& text, FilmSettings& film) {
    int width = 0;
    int height = 0;
    char rest = 0;
    if (std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &rest) != 2 || width < 1 ||
        height < 1 || width > 32768 || height > 32768)
        throw Error::usage("--size " + text + ": expected WIDTHxHEIGHT in pixels, up to 32768",
                           "for example --size 1280x720");
    film.width = width;
    film.height = height;
}

Crop parse_crop(const std::string& text, const FilmSettings& film) {
    Crop crop;
    char rest = 0;
    if (std::sscanf(text.c_str(), "%d,%d,%d,%d%c", &crop.x, &crop.y, &crop.width, &crop.height,
                    &rest) != 4 ||
        crop.x < 0 || crop.y < 0 || crop.width < 1 || crop.height < 1 ||
        crop.width > film.width - crop.x || crop.height > film.height - crop.y)
        throw Error::usage(fmt::format("--crop {}: expected x,y,width,height within {} x {} pixels",
                                       text, film.width, film.height));
    return crop;
}

void check_aovs(const std::vector<std::string>& aovs) {
    for (const std::string& name : aovs)
        if (std::find(aov_names.begin(), aov_names.end(), name) == aov_names.end())
            throw Error::usage(
                fmt::format("--aov {}: expected {}", name, fmt::join(aov_names, ", ")),
                did_you_mean(name, aov_names));
}

Shard shard_of(const RenderCommand& command) {
    if (command.shard.empty())
        return {};
    if (const std::optional<Shard> shard = parse_shard(command.shard))
        return *shard;
    throw Error::usage("--shard " + command.shard +
                           ": expected I/N with I from 1 to N, up to 65536",
                       "for example --shard 1/4");
}

// The provenance of the picture, and the options that it was rendered with.
Metadata metadata_of(const Scene& scene, const RenderCommand& command) {
    std::string seeds;
    for (const Aggregate& aggregate : scene.aggregates)
        if (aggregate.generator != "object")
            seeds += (seeds.empty() ? "" : ",") + std::to_string(aggregate.seed);
    Metadata metadata = provenance(scene);
    metadata.insert(metadata.end(),
                    {{"scree:seed", seeds}, {"scree:render_seed", std::to_string(command.seed)}});
    return metadata;
}

PngLook look_of(const RenderCommand& command, const FilmSettings& film) {
    return {command.look.view, film.exposure, command.look.depth};
}

// The beauty, the light groups, and what --aov asks for; cryptomattes add to the metadata.
std::vector<ImagePart> parts_of(const Rendered& rendered, const Scene& scene,
                                const RenderCommand& command, Metadata& metadata) {
    const auto asked = [&](std::string_view name) {
        return std::ranges::find(command.aovs, name) != command.aovs.end();
    };
    const Film& film = rendered.result.film;
    std::vector<ImagePart> parts = film.parts();
    std::erase_if(parts, [&](const ImagePart& part) {
        return part.name != "beauty" && !part.name.starts_with("light_") && !asked(part.name);
    });
    for (const std::string_view layer : cryptomatte_layers)
        if (asked(layer)) {
            Cryptomatte matte = make_cryptomatte(layer, film, scene.aggregates, rendered.materials);
            std::ranges::move(matte.parts, std::back_inserter(parts));
            std::ranges::move(matte.metadata, std::back_inserter(metadata));
        }
    return parts;
}

// `denoised`: what the .png shows, and a further part of the .exr; else both have the beauty alone.
void write_pictures(const std::string& output, const Rendered& rendered,
                    std::optional<Image> denoised, const Scene& scene, const RenderOptions& options,
                    const RenderCommand& command) {
    const RenderResult& result = rendered.result;
    const FilmSettings& film = scene.film;
    const PngLook look = look_of(command, film);
    Metadata metadata = metadata_of(scene, command);
    metadata.push_back(samples_metadata(result.stats.samples_per_pixel));
    if (!command.shard.empty())
        std::ranges::copy(
            shard_metadata({options.shard, result.stats.samples, result.cancelled, look}),
            std::back_inserter(metadata));
    std::vector<ImagePart> parts = parts_of(rendered, scene, command, metadata);
    std::optional<PictureWindow> window;
    if (options.crop)
        window = {options.crop->x, options.crop->y, film.width, film.height};
    if (denoised)
        parts.insert(parts.begin() + 1, {"denoised", std::move(*denoised), true});
    write_exr(output, parts, metadata, {}, window);
    write_look(beside(output, "png"), parts[command.denoise ? 1 : 0].image, look);
}

RenderOptions options_of(const RenderCommand& command, const Scene& scene) {
    RenderOptions options;
    options.samples = command.samples;
    options.time_limit = command.time_limit;
    options.noise = command.noise;
    options.seed = command.seed;
    options.shard = shard_of(command);
    options.mattes =
        std::ranges::find_first_of(command.aovs, cryptomatte_layers) != command.aovs.end();
    if (!command.crop.empty())
        options.crop = parse_crop(command.crop, scene.film);
    return options;
}

RenderCare care_of(const RenderCommand& command, const std::string& output,
                   const FilmSettings& film, Console& console) {
    RenderCare care;
    care.checkpoint = beside(output, "checkpoint");
    care.resume = command.resume;
    if (command.preview) {
        care.preview_every = preview_every;
        care.preview = [=, look = look_of(command, film), &console](const Film& so_far) {
            console.picture(write_look(beside(output, "png"), so_far.beauty(), look));
        };
    }
    return care;
}

int run_render(const RenderCommand& command) {
    // Everything that can be invalid is checked before rendering.
    const std::string output =
        command.output.empty() ? default_picture(command.scene.path) : command.output;
    check_picture_output(output);
    check_aovs(command.aovs);
    shard_of(command); // throws for an invalid one
    if (!command.shard.empty() && command.denoise)
        throw Error::usage("--denoise takes the whole picture, not one --shard of it");
    if (!command.stats.empty())
        check_writable(command.stats);
    to_display(Image(1, 1, {"R", "G", "B"}),
               command.look.view); // throws for an unknown view or $OCIO

    SceneRun run(command.scene);
    Session& session = run.session;
    SceneDraft draft = session.load();
    if (!draft.scene.camera)
        throw Error(Diagnostic{
            {command.scene.path, 0}, "scene.camera", "is missing; expected a camera.*", ""});
    if (draft.scene.lights.empty())
        throw Error(Diagnostic{{command.scene.path, 0},
                               "scene.lights",
                               "are missing; without light the picture is black",
                               "for example lights = { light.sky {}, light.sun {} }"});
    if (std::ranges::none_of(draft.scene.lights, gives_light))
        throw Error(Diagnostic{{command.scene.path, 0},
                               "scene.lights",
                               "are all black, and so is the picture",
                               "expected a strength and a color above 0"});
    if (!command.size.empty())
        parse_size(command.size, draft.scene.film);
    const RenderOptions options = options_of(command, draft.scene);
    const Scene scene = session.bake(std::move(draft));
    std::optional<KeepingWork> keeping;
    if (command.partial)
        keeping.emplace(&interruption());
    const Rendered rendered =
        render_scene(session, scene, options, care_of(command, output, scene.film, run.console));
    if (rendered.result.cancelled && !command.partial) {
        run.console.say(fmt::format("interrupted at {:.1f} samples per pixel, which --resume "
                                    "continues; {} is as it was",
                                    rendered.figures.stats.samples_per_pixel, output));
        throw Cancelled{};
    }
    std::optional<Image> denoised;
    if (command.denoise) {
        session.stages().begin("denoise");
        denoised = denoise(rendered.result.film);
        session.stages().end();
        run.console.say(
            fmt::format("denoised in {:.1f} s", session.stages().costs().back().wall_s));
    }
    session.stages().begin("write");
    write_pictures(output, rendered, std::move(denoised), scene, options, command);
    std::error_code ignored;
    std::filesystem::remove(rendered.spent_checkpoint, ignored);
    session.stages().end();

    const RenderStats& stats = rendered.result.stats;
    const std::string error = // unknown from one sample
        std::isfinite(stats.error) ? fmt::format("relative error about {:.2g}, ", stats.error) : "";
    run.console.say(fmt::format("render: {:g} samples per pixel, {}{:.2f} Mray/s, {}",
                                stats.samples_per_pixel, error, stats.mrays_per_s(),
                                format_duration(stats.seconds)));
    if (stats.invalid_samples > 0)
        run.console.say("dropped " + counted(stats.invalid_samples, "invalid sample"));
    run.console.say("wrote " + output + " and " + beside(output, "png"));
    if (!command.stats.empty())
        write_file(command.stats,
                   run_stats_json(session.stages(), scene.aggregates, &rendered.figures));
    if (!rendered.result.cancelled)
        return 0;
    run.console.say("interrupted: the picture holds what was done; --resume continues it");
    return interrupted_exit_code();
}

} // namespace

void add_render_command(CLI::App& app, Run& run) {
    auto options = std::make_shared<RenderCommand>();
    CLI::App* command =
        app.add_subcommand("render", "Render a scene to an .exr, with a .png beside it.");
    options->scene.add_to(*command);
    add_file_option(*command, "-o,--output", options->output,
                    "File to write: .exr (default: SCENE.exr here)");
    command->add_option("--spp", options->samples, "Samples per pixel (default: the scene's)")
        ->check(CLI::Range(1, 1 << 24));
    command->add_option("--time", options->time_limit, "Stop after this many seconds")
        ->check(problem_of_positive);
    command
        ->add_option("--noise", options->noise,
                     "Stop where the relative error of luminance is below this; 0.02 is 2%")
        ->check(problem_of_positive);
    command->add_option("--size", options->size, "Size of the picture, as in 1280x720")
        ->type_name("WxH");
    command
        ->add_option("--crop", options->crop,
                     "Render this part of the picture only, in pixels from its top left corner; it "
                     "keeps its place in the .exr")
        ->type_name("x,y,w,h");
    command->add_option("--seed", options->seed, "Seed of the samples; not of the scene")
        ->check(problem_of_seed);
    command
        ->add_option("--aov", options->aovs,
                     "Parts to write beside the beauty: " +
                         fmt::format("{}", fmt::join(aov_names, ",")))
        ->delimiter(',')
        ->allow_extra_args(false) // or it would take the scene's name too
        ->type_name("LIST");
    command->add_flag("--resume", options->resume,
                      "Continue the render that was interrupted (Ctrl-C, a crash, --time), or one "
                      "that was itself resumed, with more --spp");
    command
        ->add_option("--shard", options->shard,
                     "Render one of N shares of the picture; see scree merge --help")
        ->type_name("I/N");
    command->add_flag(
        "--preview", options->preview,
        "Refresh the .png while rendering, and show it in a terminal that has the colours");
    command->add_flag("--partial", options->partial,
                      "When interrupted, write the picture with what is done");
    command->add_flag("--denoise", options->denoise,
                      "Add a part without noise to the .exr, and show it in the .png");
    command->add_option("--view", options->look.view, "View for the .png; see `scree view --help`")
        ->type_name("NAME");
    add_png_bits_option(*command, options->look.depth);
    add_stats_option(*command, options->stats);
    command->footer(
        "Every minute, and where a render ends unfinished (Ctrl-C, --time), its state is\n"
        "written to a .checkpoint beside the .exr, from which --resume goes on.\n"
        "Example:\n  scree render scenes/toys.lua -o toys.exr --spp 64 --aov albedo,N");
    command->callback([options, &run] { run = [options] { return run_render(*options); }; });
}

} // namespace scree
