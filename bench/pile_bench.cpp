// SPDX-License-Identifier: GPL-3.0-or-later
// Benchmarks of generator.pile: the rows of table 4.1 (Sakurai 2013) by the thesis's method and by
// ours, overlap of the meshes, scaling with the number of elements, and comparison with Bullet.
//   pile_bench [table|overlap|growth|peers] [--dragon FILE.ply]     all by default
// CPU seconds of the whole process, and wall seconds on all cores.
#include "bench/bullet_heap.h"
#include "bench/measure.h"
#include "session/session.h"
#include "shapes/table.h"
#include "tests/support/plugin_params.h"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <map>
#include <set>

namespace {

using namespace scree;

using Overrides = std::map<std::string, std::string>;

/// One bake of a scene's pile.
struct Run {
    std::map<std::string, double> facts;
    double cpu = 0, wall = 0; // [s]
};

Run bake(const std::string& name, const Overrides& overrides) {
    const std::string path = std::string(SCREE_SOURCE_DIR) + "/bench/scenes/" + name;
    Session session({.path = path, .overrides = overrides, .device = "none"});
    const SceneDraft draft = session.load();
    Run run;
    const auto start = std::chrono::steady_clock::now();
    run.cpu = cpu_seconds_of([&] {
        for (const auto& [fact, value] : draft.items.front()->bake({}, 0).facts)
            run.facts[fact] = value;
    });
    run.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return run;
}

struct Row {
    const char* figure;
    int count;      // in the thesis
    double seconds; // with a GTX 570
};

constexpr Row rows[] = {
    {"4.10a", 4524, 324.2}, {"4.10c", 1234, 246.5}, {"4.10e", 2089, 182.2}, {"4.11a", 2523, 51.1},
    {"4.11b", 7400, 162.0}, {"4.12a", 2123, 145.1}, {"4.12b", 4770, 150.1}, {"4.13b", 882, 58.0},
    {"4.13c", 882, 59.9},   {"4.13d", 882, 57.5},   {"4.13e", 882, 61.5},   {"4.13f", 882, 60.1},
    {"4.13g", 882, 55.2},   {"4.13h", 882, 54.7},   {"4.13i", 882, 56.5},   {"4.14a", 2856, 339.0},
    {"4.14b", 2557, 270.6}, {"4.15a", 2986, 203.9}, {"4.15b", 3686, 244.0}, {"4.16a", 490, 19.5},
    {"4.16b", 1148, 45.4},  {"4.16c", 897, 101.7},  {"4.16d", 5939, 679.0}, {"4.16e", 676, 30.5},
    {"4.16f", 2342, 62.4}};

void print_table(const std::string& dragon) {
    fmt::print("{:6} {:>21} {:>41} {:>41}\n", "", "thesis, GTX 570", "its method, here",
               "insertion");
    fmt::print("{:6} {:>10} {:>10} {:>10} {:>8} {:>10} {:>10} {:>10} {:>8} {:>10} {:>10}\n",
               "figure", "count", "s", "count", "s", "CPU s", "overlap", "count", "s", "CPU s",
               "overlap");
    for (const Row& row : rows) {
        fmt::print("{:6} {:10} {:10.1f}", row.figure, row.count, row.seconds);
        for (const char* method : {"thesis", "insertion"}) {
            const Run run = bake("pile_table.lua", {{"row", row.figure},
                                                    {"method", method},
                                                    {"cover", method[0] == 't' ? "0" : "0.99"},
                                                    {"dragon", dragon}});
            fmt::print(" {:10.0f} {:8.2f} {:10.2f} {:9.1f}%", run.facts.at("count"), run.wall,
                       run.cpu, 100 * run.facts.at("volume_overlap"));
        }
        fmt::print("\n");
    }
}

void print_overlap() {
    fmt::print("{:30} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8}\n", "rice on the bunny, T = 0", "count",
               "cover", "mean", "99%", "most", "volume");
    for (const auto& [method, cover] :
         {std::pair("thesis", "0"), std::pair("insertion", "0"), std::pair("insertion", "0.99")}) {
        const Run run =
            bake("pile_scale.lua", {{"method", method}, {"cover", cover}, {"measure", "1000000"}});
        fmt::print("{:12} cover = {:9} {:8.0f} {:8.4f} {:8.5f} {:8.5f} {:8.5f} {:7.3f}%\n", method,
                   cover, run.facts.at("count"), run.facts.at("cover"), run.facts.at("depth_mean"),
                   run.facts.at("depth_99"), run.facts.at("depth_max"),
                   100 * run.facts.at("volume_overlap"));
    }
}

void print_growth() {
    fmt::print("{:>10} {:>8} {:>8} {:>10} {:>10} {:>10}\n", "kept", "s", "CPU s", "preparing",
               "sampling", "placing");
    for (const char* size : {"0.175", "0.35", "0.79"}) {
        const Run run = bake("pile_scale.lua", {{"size", size}});
        fmt::print("{:10.0f} {:8.2f} {:8.2f} {:10.2f} {:10.2f} {:10.2f}\n", run.facts.at("count"),
                   run.wall, run.cpu, run.facts.at("preparing_seconds"),
                   run.facts.at("sampling_seconds"), run.facts.at("placing_seconds"));
    }
}

void print_peers() {
    const Mesh grain = tests::make(component_table(), "rice", {});
    for (const auto& [count, size] : {std::pair(500, "0.055"), std::pair(2000, "0.11")}) {
        const Run ours = bake("pile_scale.lua", {{"size", size}});
        fmt::print("insertion: {:.0f} grains on a bunny in {:.3f} CPU s\n", ours.facts.at("count"),
                   ours.cpu);
        const auto bullet = bench::drop_with_bullet(grain, count);
        if (!bullet) {
            fmt::print("Bullet: not installed when this was built (libbullet-dev)\n");
            return;
        }
        const double each = ours.cpu / ours.facts.at("count");
        fmt::print(
            "Bullet: {} hulls in a box in {:.1f} CPU s ({:.1f} s simulated, at {:.2f} lengths "
            "per second, {:.3f} deep): {:.0f} times as long for each\n",
            count, bullet->cpu_seconds, bullet->simulated_seconds, bullet->speed, bullet->deepest,
            bullet->cpu_seconds / count / each);
    }
}

} // namespace

int main(int count, char** arguments) {
    std::setvbuf(stdout, nullptr, _IOLBF, 0); // lines appear as they are measured
    std::set<std::string> named;
    std::string dragon;
    for (int i = 1; i < count; ++i) {
        if (arguments[i] == std::string("--dragon") && i + 1 < count)
            dragon = arguments[++i];
        else
            named.insert(arguments[i]);
    }
    const auto wanted = [&](const char* name) { return named.empty() || named.contains(name); };
    if (wanted("table"))
        print_table(dragon);
    if (wanted("overlap"))
        print_overlap();
    if (wanted("growth"))
        print_growth();
    if (wanted("peers"))
        print_peers();
}
