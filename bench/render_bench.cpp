// SPDX-License-Identifier: GPL-3.0-or-later
// Path tracing of a heap of many instances: which share of the time is spent in Embree?
//   render_bench [mesh.obj] [runs] [samples]
// And how long do others take for as good a picture?
//   render_bench --peers [--quick] [scene ...]
#include "bench/measure.h"
#include "bench/render_peers.h"
#include "render/render.h"

#include "core/parallel.h"
#include "core/random.h"
#include "formats/read_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <span>

using namespace scree;

namespace {

constexpr int instance_count = 5000;

Mesh read_component(const std::string& path) {
    Mesh mesh = read_mesh(path);
    normalise_size(mesh, 0.1);
    if (mesh.normals.empty())
        compute_normals(mesh, radians(180));
    return mesh;
}

Aggregate scatter(std::shared_ptr<const Mesh> mesh) {
    Aggregate aggregate;
    aggregate.generator = "bench";
    aggregate.prototypes.push_back(
        {"mesh",
         std::move(mesh),
         nullptr,
         {std::make_shared<const Material>(Matte{{{Color(0.7F, 0.7F, 0.7F), nullptr}, {}}})}});
    Random random(1, Purpose::test);
    for (int i = 0; i < instance_count; ++i) {
        Matrix turn;
        turn.setAxisAngle(Vec3(0.0F, 1.0F, 0.0F), static_cast<float>(random.uniform(0, 2 * pi)));
        Matrix place;
        place.setTranslation(Vec3(static_cast<float>(random.uniform(-2, 2)),
                                  static_cast<float>(random.uniform(0, 0.4)),
                                  static_cast<float>(random.uniform(-2, 2))));
        aggregate.instances.push_back({0, WideMatrix(turn * place), random.uniform_float(), 0, 1});
    }
    return aggregate;
}

// Rays per CPU second of Embree alone. The rays are diffuse bounces off the visible surfaces,
// generated in advance, in the renderer's tile order.
double bare_rays_per_second(const World& world, const Camera& camera, const FilmSettings& film) {
    const CameraRays rays_of(camera, film.width, film.height);
    std::vector<Ray> rays;
    Random random(2, Purpose::test);
    for (int y = 0; y < film.height; ++y)
        for (int x = 0; x < film.width; ++x) {
            const CameraRay first =
                rays_of.ray(static_cast<float>(x), static_cast<float>(y), {0, 0});
            Ray ray{first.origin, first.direction};
            for (int edge = 0; edge < 5; ++edge) {
                rays.push_back(ray);
                Hit hit;
                if (!world.hit(ray, hit))
                    break;
                Vec3 d;
                do
                    d = Vec3(static_cast<float>(random.uniform(-1, 1)),
                             static_cast<float>(random.uniform(-1, 1)),
                             static_cast<float>(random.uniform(-1, 1)));
                while (d.dot(d) > 1 || d.dot(d) < 1e-4F);
                // Cosine-weighted around the normal on the ray's side.
                const float side = hit.normal.dot(ray.direction) < 0 ? 1.0F : -1.0F;
                ray = hit.leave((d.normalized() + hit.normal * (0.999F * side)).normalized());
            }
        }
    std::uint64_t ticks_in_embree = 0;
    const std::clock_t start = std::clock();
    Hit hit;
    for (const Ray& ray : rays)
        world.hit(ray, hit, &ticks_in_embree);
    return double(rays.size()) * CLOCKS_PER_SEC / double(std::clock() - start);
}

} // namespace

int main(int count, char** arguments) {
    const std::vector<std::string> given(arguments + 1, arguments + count);
    if (!given.empty() && given[0] == "--peers")
        return bench::render_peers(std::span(given).subspan(1));
    if (!given.empty() && given[0].starts_with('-')) {
        const bool help = given[0] == "--help" || given[0] == "-h";
        std::FILE* out = help ? stdout : stderr;
        if (!help)
            fmt::print(out, "there is no option {}\n", given[0]);
        fmt::print(out, "Usage: ./scree bench render [MESH.obj [RUNS [SAMPLES]]]\n"
                        "       ./scree bench render --peers [--quick] [SCENE ...]\n");
        return help ? 0 : 2;
    }
    const std::string path = count > 1 ? arguments[1] : "/usr/share/glmark2/models/bunny.obj";
    const int runs = count > 2 ? std::atoi(arguments[2]) : 3;
    const auto mesh = std::make_shared<Mesh>(read_component(path));
    const std::vector<Aggregate> aggregates = {scatter(mesh)};
    const std::vector<Light> lights = {Sky{}, Sun{}};
    const auto build_start = std::chrono::steady_clock::now();
    const World world(aggregates, lights);
    const std::chrono::duration<double> build = std::chrono::steady_clock::now() - build_start;
    Camera camera;
    FilmSettings film;
    camera.from = {0.0F, 2.0F, 3.0F};
    film.width = 640;
    film.height = 360;
    film.samples = count > 3 ? std::atoi(arguments[3]) : 64;
    film.depth = 5;
    fmt::print("{} instances of {} triangles, {:.1f} MiB, built in {:.2f} s, {} threads\n",
               world.instance_count(), mesh->triangles.size(),
               double(world.memory_bytes()) / (1 << 20), build.count(), thread_count());
    std::vector<double> rates;
    std::vector<double> cpu_rates;
    std::vector<double> shares;
    for (int run = 0; run < runs; ++run) {
        const RenderStats stats = render(world, camera, film, {}).stats;
        rates.push_back(stats.mrays_per_s());
        cpu_rates.push_back(double(stats.rays) / stats.cpu_seconds * 1e-6);
        shares.push_back(stats.embree_share);
        fmt::print("run {}: {:.1f} s, CPU {:.1f} s, {:.2f} Mray/s, {:.2f} per CPU second, "
                   "embree_share {:.3f}\n",
                   run + 1, stats.seconds, stats.cpu_seconds, rates.back(), cpu_rates.back(),
                   shares.back());
    }
    fmt::print("median: {:.2f} Mray/s, {:.2f} per CPU second, embree_share {:.3f}\n", median(rates),
               median(cpu_rates), median(shares));
    fmt::print("bare Embree, diffuse bounces, one thread: {:.2f} Mray per CPU second\n",
               bare_rays_per_second(world, camera, film) * 1e-6);
}
