// SPDX-License-Identifier: GPL-3.0-or-later
// The denoiser: what it leaves of the error of pictures with few samples, and how long it takes.
#include "bench/measure.h"
#include "bench/picture_error.h"
#include "bench/tables.h"
#include "render/film/denoise.h"
#include "session/render_scene.h"

#include <array>
#include <chrono>

using namespace scree;

namespace {

constexpr int width = 1280;
constexpr int height = 720;
constexpr int samples = 16;
constexpr int reference_samples = 1024;
// The middle of the picture, so that details have the size that they have in the whole one.
constexpr Crop middle{560, 315, 160, 90};

struct Measured {
    const char* file; // in scenes/
    std::map<std::string, std::string> overrides{};
};

const std::array<Measured, 7> scenes{{
    {"toys.lua"},
    {"pile_hardware.lua"},
    {"pile_leaves.lua"},
    {"fibres_noodles.lua"},
    {"rocks_river.lua"},
    {"wooden_bowl.lua"},
    {"leather.lua"},
}};

Scene baked(Session& session) {
    Scene scene = session.bake(session.load());
    scene.film.width = width;
    scene.film.height = height;
    return scene;
}

void print_errors() {
    fmt::print("relMSE of {} samples a pixel against {}, {} x {} pixels in the middle of {} x {}\n",
               samples, reference_samples, middle.width, middle.height, width, height);
    fmt::print("{:22}{:>10}{:>10}{:>8}\n", "scene", "raw", "denoised", "ratio");
    for (const Measured& measured : scenes) {
        Session session(
            {SCREE_SOURCE_DIR "/scenes/" + std::string(measured.file), measured.overrides});
        const Scene scene = baked(session);
        const World world(scene.aggregates, scene.lights, {}, world_origin(scene.camera.value()));
        const auto film_of = [&](int count, std::uint64_t seed) {
            RenderOptions options;
            options.samples = count;
            options.seed = seed;
            options.crop = middle;
            return render(world, scene.camera.value(), scene.film, options).film;
        };
        const Image reference = film_of(reference_samples, 99).beauty();
        const Film film = film_of(samples, 0);
        const double raw = bench::relative_error(film.beauty(), reference);
        const double denoised = bench::relative_error(denoise(film), reference);
        fmt::print("{:22}{:>10.5f}{:>10.5f}{:>8.3f}\n", measured.file, raw, denoised,
                   denoised / raw);
    }
}

void print_time() {
    Session session({SCREE_SOURCE_DIR "/scenes/toys.lua"});
    const Scene scene = baked(session);
    RenderOptions options;
    options.samples = samples;
    const Film film = render_scene(session, scene, options).result.film;
    std::vector<double> wall;
    std::vector<double> cpu;
    for (int run = 0; run < 5; ++run) {
        const auto start = std::chrono::steady_clock::now();
        cpu.push_back(cpu_seconds_of([&] { denoise(film); }));
        wall.push_back(
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    fmt::print("toys.lua at {} x {}, {} threads, median of {}: {:.2f} s, CPU {:.2f} s\n", width,
               height, thread_count(), wall.size(), median(wall), median(cpu));
}

} // namespace

int main(int count, char** arguments) {
    return bench::run_tables(
        count, arguments,
        {{"time", "Seconds for a picture of 1280 x 720.", print_time},
         {"error", "Error before and after on seven scenes, minutes each.", print_errors}});
}
