// SPDX-License-Identifier: GPL-3.0-or-later
// What many instances cost, one of Embree's each and all as one geometry of ours: time to build,
// memory, and rays.
#include "bench/measure.h"
#include "bench/tables.h"
#include "render/render.h"

#include "core/frame.h"
#include "core/random.h"
#include "core/warps.h"
#include "formats/read_mesh.h"

#include <array>
#include <limits>
#include <optional>

using namespace scree;

namespace {

constexpr int runs = 5;     // of which the median counts
constexpr int pixels = 400; // of a side of the picture
constexpr int diffuse_of_a_pixel = 2;

std::shared_ptr<const Mesh> component() {
    Mesh mesh = read_mesh("/usr/share/glmark2/models/bunny.obj");
    normalise_size(mesh, 0.1);
    return std::make_shared<const Mesh>(std::move(mesh));
}

/// A bed of the mesh, as deep and as dense for any count.
std::vector<Aggregate> bed(const std::shared_ptr<const Mesh>& mesh, std::size_t count) {
    Aggregate aggregate;
    aggregate.generator = "bench";
    aggregate.prototypes.push_back({.name = "mesh", .shape = mesh});
    aggregate.instances.reserve(count);
    const double half = 0.5 * std::sqrt(double(count) / 300);
    Random random(1, Purpose::test);
    for (std::size_t i = 0; i < count; ++i) {
        const Vec3 about = warp::sphere(Vec2f(random.uniform_float(), random.uniform_float()));
        WideMatrix place;
        place.setAxisAngle(WideVec3(about), random.uniform(0, 2 * pi));
        const WideVec3 to(random.uniform(-half, half), random.uniform(0, 0.4),
                          random.uniform(-half, half));
        for (int axis = 0; axis < 3; ++axis)
            place[3][axis] = to[axis];
        aggregate.instances.push_back({.prototype = 0, .world_from_object = place});
    }
    return {std::move(aggregate)};
}

/// Rays of a camera that sees the whole bed, by tiles as the renderer goes.
std::vector<Ray> primary_rays(const Box3& bounds) {
    constexpr int tile = 16;
    const float side = bounds.size().x;
    const Vec3 eye(0.0F, side, side);
    std::vector<Ray> rays;
    for (int block = 0; block < pixels * pixels; ++block) {
        const int in_tile = block % (tile * tile);
        const int number = block / (tile * tile);
        const int x = number % (pixels / tile) * tile + in_tile % tile;
        const int y = number / (pixels / tile) * tile + in_tile / tile;
        const Vec3 target((float(x) / pixels - 0.5F) * side, 0.2F,
                          (float(y) / pixels - 0.5F) * side);
        rays.push_back({eye, (target - eye).normalized()});
    }
    return rays;
}

/// Rays that leave what the given ones meet, in all directions.
std::vector<Ray> diffuse_rays(const World& world, const std::vector<Ray>& from) {
    std::vector<Ray> rays;
    Random random(2, Purpose::test);
    Hit hit;
    for (const Ray& ray : from)
        for (int i = 0; i < diffuse_of_a_pixel; ++i)
            if (world.hit(ray, hit)) {
                const Vec2f u(random.uniform_float(), random.uniform_float());
                const float side = hit.normal.dot(ray.direction) < 0 ? 1.0F : -1.0F;
                const Frame frame(hit.normal * side);
                rays.push_back(hit.leave(frame.world_from_local(warp::cosine_hemisphere(u))));
            }
    return rays;
}

/// One of the two ways to keep the instances.
struct Way {
    const char* name;
    std::size_t many;
    std::optional<World> world{};
    double build_s = 0;                         // of the CPU
    double resident = 0;                        // [B] more for the world, as the system counts
    std::array<std::vector<double>, 3> rates{}; // [Mray / CPU s] primary, diffuse, occlusion
};

double rate(std::size_t count, const auto& work) {
    return double(count) / cpu_seconds_of(work) * 1e-6;
}

void measure(Way& way, const std::vector<Ray>& primary, const std::vector<Ray>& diffuse) {
    const World& world = *way.world;
    const auto find = [&](const std::vector<Ray>& rays) {
        std::size_t found = 0;
        for (const Ray& ray : rays)
            found += world.find(ray).found() ? 1 : 0;
        return found;
    };
    way.rates[0].push_back(rate(primary.size(), [&] { find(primary); }));
    way.rates[1].push_back(rate(diffuse.size(), [&] { find(diffuse); }));
    way.rates[2].push_back(rate(diffuse.size(), [&] {
        for (const Ray& ray : diffuse)
            world.occluded(ray);
    }));
}

void compare(const std::shared_ptr<const Mesh>& mesh, std::size_t count) {
    const std::vector<Aggregate> one = bed(mesh, 1);
    const World shared(one, {}); // what does not grow with the count
    const std::vector<Aggregate> aggregates = bed(mesh, count);
    Way ways[] = {{"Embree's", std::numeric_limits<std::size_t>::max()}, {"together", 0}};
    for (Way& way : ways) {
        const double before = resident_bytes();
        way.build_s = cpu_seconds_of([&] {
            way.world.emplace(aggregates, std::span<const Light>{}, Context{}, WideVec3(0),
                              WorldLimits{.many_instances = way.many});
        });
        way.resident = resident_bytes() - before;
    }
    const std::vector<Ray> primary = primary_rays(ways[0].world->bounds());
    const std::vector<Ray> diffuse = diffuse_rays(*ways[0].world, primary);
    for (int run = 0; run < runs; ++run)
        for (Way& way : ways)
            measure(way, primary, diffuse);
    for (const Way& way : ways) {
        const auto each = [&](double all) {
            return (all - double(shared.memory_bytes())) / double(count);
        };
        // Few are lost among what the process had before and uses again.
        const std::string resident =
            count >= 100'000 ? fmt::format("{:.0f}", each(way.resident)) : "";
        fmt::print("{:>9} {:10} {:8.2f} {:8.0f} {:>8} {:8.0f}", count, way.name, way.build_s,
                   each(double(way.world->memory_bytes())), resident,
                   each(double(way.world->peak_bytes())));
        for (const std::vector<double>& rates : way.rates)
            fmt::print(" {:9.2f}", median(rates));
        fmt::print("\n");
    }
    fmt::print("{:>9} {:10} {:8.2f} {:26}", "", "ratio", ways[1].build_s / ways[0].build_s, "");
    for (int kind = 0; kind < 3; ++kind)
        fmt::print(" {:9.2f}", median(ways[1].rates[kind]) / median(ways[0].rates[kind]));
    fmt::print("\n");
}

void print_counts() {
    const std::shared_ptr<const Mesh> mesh = component();
    fmt::print("{} triangles; Mray a CPU second, one thread\n", mesh->triangles.size());
    fmt::print("{:>9} {:10} {:>8} {:>8} {:>8} {:>8} {:>9} {:>9} {:>9}\n", "instances", "way",
               "CPU s", "B each", "resident", "at peak", "primary", "diffuse", "occluded");
    for (const std::size_t count : {1'000U, 10'000U, 100'000U, 1'000'000U})
        compare(mesh, count);
}

} // namespace

int main(int count, char** arguments) {
    return bench::run_tables(
        count, arguments,
        {{"counts", "1,000 to 1,000,000 instances, kept both ways", print_counts}});
}
