// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/render_peers.h"

#include "bench/cycles.h"
#include "bench/measure.h"
#include "bench/peer_scene.h"
#include "bench/picture_error.h"
#include "core/display_encoding.h"
#include "formats/surface_texture.h"
#include "render/render.h"
#include "session/session.h"
#include "session/texture_subject.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>

namespace scree::bench {

namespace {

constexpr int threads = 2;
constexpr int reference_seed = 1000; // none of the runs'
constexpr int blur = 8;              // pixels
const std::string bunny = "/usr/share/glmark2/models/bunny.obj";
const std::string scripts = SCREE_SOURCE_DIR "/bench/scenes/peers/";
const std::vector<std::string> all_scenes{"bunnies", "toys", "glass", "lamps", "room", "fibres"};

struct Settings {
    std::vector<std::string> scenes{};
    int samples = 64;
    int reference = 1024; // samples
    int runs = 3;
    int shrink = 1; // factor of the picture's sides
};

/// A picture with what it took.
struct Shot {
    Image picture;
    double cpu_seconds = 0;
};

/// A renderer's figures for a scene.
struct Figures {
    Image reference;
    double cpu_seconds = 0; // median
    double error = 0;       // median of the errors against its own reference
};

// A folder for what is handed to other programs.
std::string folder_of(const std::string& scene) {
    std::string folder = SCREE_SOURCE_DIR "/build/peers/" + scene;
    std::filesystem::create_directories(folder);
    return folder;
}

// Bakes the picture that is on the walls of the room.
std::string marble_picture() {
    const std::string script = scripts + "marble.lua";
    Session session({.path = script});
    const Scene scene = session.bake(session.load());
    const TextureSource source = texture_subject(script, scene, 0).source;
    Image image = surface_texture(source, UvRaster(*source.mesh, 1024, 1024), TextureChannel::color,
                                  session.context("texture"));
    for (float& v : image.pixels)
        v = display_from_linear(std::clamp(v, 0.0F, 1.0F));
    std::string path = folder_of("room") + "/marble.png";
    write_png(path, image);
    return path;
}

Scene load(const std::string& name, const Settings& settings) {
    SessionOptions options{.path = scripts + name + ".lua"};
    if (name == "room")
        options.overrides["marble"] = marble_picture();
    Session session(options);
    Scene scene = session.bake(session.load());
    scene.film.width /= settings.shrink;
    scene.film.height /= settings.shrink;
    return scene;
}

// Runs a renderer, given as a function of samples and seed.
class Measurement {
  public:
    template <class Render>
    void run(const Render& render, const Settings& settings, int seed) {
        shots_.push_back(render(settings.samples, seed));
    }
    template <class Render>
    Figures figures(const Render& render, const Settings& settings) const {
        Figures out{render(settings.reference, reference_seed).picture};
        std::vector<double> seconds;
        std::vector<double> errors;
        for (const Shot& shot : shots_) {
            seconds.push_back(shot.cpu_seconds);
            errors.push_back(relative_error(shot.picture, out.reference));
        }
        out.cpu_seconds = median(seconds);
        out.error = median(errors);
        return out;
    }

  private:
    std::vector<Shot> shots_;
};

void print_row(const std::string& name, const Figures& scree,
               const std::optional<Figures>& cycles) {
    fmt::print("{:10}{:>9.2f}{:>10.5f}", name, scree.cpu_seconds, scree.error);
    if (cycles) {
        // Errors of independent samples fall as the time grows.
        const double ratio =
            scree.cpu_seconds * scree.error / (cycles->cpu_seconds * cycles->error);
        const double theirs = mean_luminance(cycles->reference);
        fmt::print("{:>9.2f}{:>10.5f}{:>9.2f}{:>+9.2f}%{:>10.5f}\n", cycles->cpu_seconds,
                   cycles->error, ratio, 100 * (mean_luminance(scree.reference) / theirs - 1),
                   relative_error(shrunk(scree.reference, blur), shrunk(cycles->reference, blur)));
    } else {
        fmt::print("{:>9}{:>10}{:>9}{:>10}{:>10}\n", "-", "-", "-", "-", "-");
    }
}

void measure(const std::string& name, const Settings& settings, bool with_cycles) {
    const Scene scene = load(name, settings);
    const std::string folder = folder_of(name);
    write_peer_scene(scene, folder);
    const World world(scene.aggregates, scene.lights, {}, world_origin(scene.camera.value()));
    const auto in_scree = [&](int samples, int seed) {
        RenderOptions options;
        options.samples = samples;
        options.seed = static_cast<std::uint64_t>(seed);
        options.threads = threads;
        const RenderResult result = render(world, scene.camera.value(), scene.film, options);
        return Shot{result.film.beauty(), result.stats.cpu_seconds};
    };
    const auto in_cycles = [&](int samples, int seed) {
        CyclesRun run = run_cycles(folder, samples, seed);
        return Shot{std::move(run.picture), run.cpu_seconds};
    };
    Measurement scree;
    Measurement cycles;
    for (int seed = 1; seed <= settings.runs; ++seed) { // in turn: other load meets both
        scree.run(in_scree, settings, seed);
        if (with_cycles)
            cycles.run(in_cycles, settings, seed);
    }
    const Figures ours = scree.figures(in_scree, settings);
    std::optional<Figures> theirs;
    if (with_cycles)
        theirs = cycles.figures(in_cycles, settings);
    print_row(name, ours, theirs);
}

void print_table(const Settings& settings) {
    const bool with_cycles = has_blender();
    if (!with_cycles)
        fmt::print("blender is not installed, so there is nothing to compare with:\n"
                   "  apt-get install --no-install-recommends blender python3-numpy\n");
    fmt::print("{} samples a pixel against {}, {} threads, medians of {} runs\n", settings.samples,
               settings.reference, threads, settings.runs);
    fmt::print("{:10}{:>19}{:>19}{:>9}{:>20}\n", "", "Scree", "Cycles", "time to",
               "Scree to Cycles");
    fmt::print("{:10}{:>9}{:>10}{:>9}{:>10}{:>9}{:>10}{:>10}\n", "scene", "CPU s", "relMSE",
               "CPU s", "relMSE", "error", "mean", "blurred");
    for (const std::string& name : settings.scenes) {
        if (name == "bunnies" && !std::filesystem::exists(bunny)) {
            fmt::print("bunnies: left out, {} is missing (apt-get install glmark2-data)\n", bunny);
            continue;
        }
        measure(name, settings, with_cycles);
    }
}

constexpr const char* usage = R"(Usage: ./scree bench render --peers [--quick] [SCENE ...]
Renders scenes in Scree and, where Debian's blender is installed, in Cycles, and prints how long both
take and how far they are from their own pictures of 16 times the samples: see docs/peers.md.
  --quick   small pictures of few samples, to see whether it works
)";

// Nothing on --help and mistakes; `code` becomes what to exit with.
std::optional<Settings> read(std::span<const std::string> arguments, int& code) {
    Settings settings;
    for (const std::string& argument : arguments) {
        if (argument == "--quick") {
            settings.samples = 16;
            settings.reference = 256;
            settings.runs = 1;
            settings.shrink = 2;
        } else if (std::ranges::find(all_scenes, argument) != all_scenes.end()) {
            settings.scenes.push_back(argument);
        } else {
            const bool help = argument == "--help" || argument == "-h";
            std::FILE* out = help ? stdout : stderr;
            if (!help)
                fmt::print(out, "there is no option or scene {}\n", argument);
            fmt::print(out, "{}Scenes, all unless some are named: {}\n", usage,
                       fmt::join(all_scenes, " "));
            code = help ? 0 : 2;
            return {};
        }
    }
    if (settings.scenes.empty())
        settings.scenes = all_scenes;
    return settings;
}

} // namespace

int render_peers(std::span<const std::string> arguments) {
    std::setvbuf(stdout, nullptr, _IOLBF, 0); // lines appear as they are measured
    int code = 0;
    try {
        if (const std::optional<Settings> settings = read(arguments, code))
            print_table(*settings);
        return code;
    } catch (const Error& error) {
        fmt::print(stderr, "{}\n", error.what());
        return static_cast<int>(error.fault());
    }
}

} // namespace scree::bench
