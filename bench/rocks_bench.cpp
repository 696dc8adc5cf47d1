// SPDX-License-Identifier: GPL-3.0-or-later
// Benchmarks of generator.rocks: Table 1 of Sakurai & Miyata by their method and by the mosaic, the
// growth of dropping with the number of rocks, how exactly rocks touch, and the rock's shape.
#include "bench/measure.h"
#include "bench/tables.h"
#include "generators/rocks/rocks_generator.h"
#include "geometry/rock/geodesic_sphere.h"
#include "geometry/rock/rock.h"
#include "tests/support/plugin_params.h"
#include "tests/support/regions.h"

#include <chrono>
#include <map>

namespace {

using namespace scree;

using Values = std::map<std::string, Value>;

/// One bake.
struct Run {
    Aggregate rocks;
    std::map<std::string, double> facts;
    double wall = 0; // [s]
};

Run bake(const Values& values) {
    Registry<Generator> table("generator");
    table.add(rocks_plugin());
    const Bake work = tests::make(table, "rocks", values);
    Run run;
    const auto start = std::chrono::steady_clock::now();
    run.rocks = work({});
    run.wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    for (const auto& [name, value] : run.rocks.facts)
        run.facts[name] = value;
    return run;
}

/// A class of Table 1; lengths in pixels, of which one is a millimetre here.
struct Class {
    double radius, share;
    Vec3 widening, height;
};

struct Column {
    const char* name;
    double seconds; // in print
    std::vector<Class> classes;
};

const std::vector<Column>& columns() {
    const auto three = [](double a, double b, double c) {
        return std::vector<Class>{{90, a, Vec3(0), {45, 0, 0}},
                                  {30, b, Vec3(0), {15, 0, 0}},
                                  {10, c, Vec3(0), {5, 0, 0}}};
    };
    const auto one = [](double radius, const Vec3& widening, const Vec3& height) {
        return std::vector<Class>{{radius, 0.5, widening, height}};
    };
    static const std::vector<Column> table{{"1",
                                            3.63,
                                            {{90, 0.2, {0, 6, 6}, {14, 14, 9}},
                                             {30, 0.24, {0, 6, 2}, {5, 5, 3}},
                                             {10, 0.56, {2, 2, 2}, {2, 2, 1}}}},
                                           {"11a", 0.05, one(90, Vec3(0), {45, 0, 0})},
                                           {"11b", 0.75, one(30, Vec3(0), {15, 0, 0})},
                                           {"11c", 3.5, one(10, Vec3(0), {5, 0, 0})},
                                           {"12a", 3.21, three(0.5, 0.25, 0.25)},
                                           {"12b", 3.22, three(0.25, 0.5, 0.25)},
                                           {"12c", 3.23, three(0.25, 0.25, 0.5)},
                                           {"13a", 0.05, one(90, {10, 0, 0}, {45, 0, 0})},
                                           {"13b", 0.05, one(90, {0, 10, 0}, {45, 0, 0})},
                                           {"13c", 0.05, one(90, {0, 0, 10}, {45, 0, 0})},
                                           {"14a", 0.05, one(90, Vec3(0), {67, 0, 0})},
                                           {"14b", 0.05, one(90, Vec3(0), {0, 45, 0})},
                                           {"14c", 0.05, one(90, Vec3(0), {0, 0, 45})}};
    return table;
}

Value classes_of(const Column& column) {
    std::vector<Params> classes;
    const Plugin<Generator> plugin = rocks_plugin();
    for (const Class& given : column.classes) {
        Params params;
        for (const ParamSpec& spec : plugin.params)
            if (spec.name == "sizes")
                params = tests::defaults(spec.fields, "sizes");
        params.set("radius", given.radius * 1e-3);
        params.set("share", given.share);
        params.set("widening", given.widening * 1e-3F);
        params.set("height", given.height * 1e-3F);
        classes.push_back(std::move(params));
    }
    return std::make_shared<const std::vector<Params>>(std::move(classes));
}

void print_table_1() {
    fmt::print(
        "Table 1, 953 x 953 mm; shares of the classes, the ground between all cells, seconds\n");
    fmt::print("{:>5} {:>7} {:>7} {:>20} {:>7} {:>7} {:>7} {:>8}\n", "fig.", "method", "rocks",
               "shares", "gap", "folded", "s", "in print");
    for (const Column& column : columns())
        for (const char* method : {"paper", "mosaic"}) {
            const Run run = bake({{"method", std::string(method)},
                                  {"domain", tests::shared_square(0.953)},
                                  {"sizes", classes_of(column)},
                                  {"seed", std::int64_t{1}}});
            std::string shares;
            for (std::size_t c = 0; c < column.classes.size(); ++c)
                shares += fmt::format(" {:.4f}", run.facts.at(fmt::format("share_{}", c + 1)));
            const bool is_paper = run.facts.contains("folded");
            fmt::print("{:>5} {:>7} {:>7} {:>20} {:>7.4f} {:>7} {:>7.3f} {:>8}\n", column.name,
                       method, run.facts.at("count"), shares, run.facts.at("gap"),
                       is_paper ? fmt::format("{}", run.facts.at("folded")) : "", run.wall,
                       is_paper ? fmt::format("{:.2f}", column.seconds) : "");
        }
}

void print_growth() {
    fmt::print("Dropped rocks, D 4 to 40 cm, N(>D) ~ D^-2.5, 0.8 of the ground: growth\n");
    fmt::print("{:>8} {:>9} {:>8} {:>10} {:>14}\n", "rocks", "left out", "s", "us a rock",
               "bytes a rock");
    for (const double wanted : {1000.0, 10000.0, 100000.0}) {
        // Of these sizes a square metre holds 1,146 rocks for each cover of 1.
        const double side = std::sqrt(wanted / (0.8 * 331));
        const Run run = bake({{"domain", tests::shared_square(side)},
                              {"smallest", 0.04},
                              {"largest", 0.4},
                              {"cover", 0.8}});
        const double count = run.facts.at("count");
        fmt::print("{:>8} {:>9} {:>8.2f} {:>10.0f} {:>14}\n", count, run.facts.at("left_out"),
                   run.wall, 1e6 * run.wall / count, sizeof(Instance));
    }
}

void print_contact() {
    fmt::print("How exactly dropped rocks touch; depths and gaps in longest axes, of 500 rocks\n");
    fmt::print("{:>8} {:>7} {:>9} {:>10} {:>10} {:>10}\n", "preset", "rocks", "left out",
               "depth 99%", "deepest", "gap 99%");
    for (const char* preset : {"river", "scree", "moraine", "desert"}) {
        const Run run = bake({{"preset", std::string(preset)},
                              {"distribution", std::string("power")},
                              {"domain", tests::shared_square(4)},
                              {"smallest", 0.08},
                              {"largest", 0.8},
                              {"cover", 0.8},
                              {"measure", std::int64_t{500}}});
        fmt::print("{:>8} {:>7} {:>9} {:>10.5f} {:>10.5f} {:>10.5f}\n", preset,
                   run.facts.at("count"), run.facts.at("left_out"), run.facts.at("depth_99"),
                   run.facts.at("depth_max"), run.facts.at("gap_99"));
    }
}

/// Wadell's roundness of a rock seen from above: the mean radius of its outline's corners over that
/// of the largest inscribed circle. Of the outline's hull, from its support function h(angle): the
/// radius of curvature is h + h'', smoothed over 15 degrees; corners are its minima below the
/// inscribed radius.
double roundness(const std::vector<WideVec3>& vertices) {
    constexpr int steps = 720;
    constexpr int smooth = 15; // on either side, half degrees
    std::vector<double> support(steps, 0.0);
    for (int i = 0; i < steps; ++i)
        for (const WideVec3& v : vertices)
            support[std::size_t(i)] =
                std::max(support[std::size_t(i)],
                         v.x * std::cos(2 * pi * i / steps) + v.z * std::sin(2 * pi * i / steps));
    const auto at = [&](const std::vector<double>& values, int i) {
        return values[std::size_t((i + steps) % steps)];
    };
    // The mean of h + h'' over a window: exact from the slopes at its ends.
    const double window = 2 * pi * (2 * smooth) / steps;
    std::vector<double> radius(steps);
    for (int i = 0; i < steps; ++i) {
        double mean = 0;
        for (int k = -smooth; k < smooth; ++k)
            mean += at(support, i + k) / (2 * smooth);
        const double step = 2 * pi / steps;
        const auto slope = [&](int k) {
            return (at(support, k + 1) - at(support, k - 1)) / (2 * step);
        };
        radius[std::size_t(i)] =
            std::max(0.0, mean + (slope(i + smooth) - slope(i - smooth)) / window);
    }
    const double inscribed = *std::ranges::min_element(support);
    double sum = 0;
    int corners = 0;
    for (int i = 0; i < steps; ++i)
        if (at(radius, i) <= at(radius, i - 1) && at(radius, i) < at(radius, i + 1) &&
            at(radius, i) < inscribed) {
            sum += at(radius, i);
            ++corners;
        }
    return corners == 0 ? 1 : sum / corners / inscribed;
}

void print_shape() {
    fmt::print("Rocks of many triangles: one prototype, ms of one core\n");
    for (const int level : {4, 8, 16, 32}) {
        geodesic_sphere(level);
        std::vector<double> times;
        for (std::uint64_t seed = 0; seed < 15; ++seed)
            times.push_back(1e3 * cpu_seconds_of([&] {
                                rock_mesh(Rock(RockSettings{.seed = seed}).vertices(level), level);
                            }));
        fmt::print("  {:>6} triangles {:>7.2f}\n", 20 * level * level, median(times));
    }
    fmt::print("Roundness by wear, 40 rocks each seen from above\n");
    for (const double wear : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        double sum = 0;
        for (std::uint64_t seed = 0; seed < 40; ++seed)
            sum += roundness(Rock(RockSettings{.wear = wear, .seed = seed}).vertices(16)) / 40;
        fmt::print("  wear {:.2f}: {:.3f}\n", wear, sum);
    }
}

} // namespace

int main(int count, char** arguments) {
    return bench::run_tables(
        count, arguments,
        {{"table", "Table 1 by the paper's method and by the mosaic", print_table_1},
         {"growth", "time by the number of dropped rocks", print_growth},
         {"contact", "how deep rocks are in others, and gaps below them", print_contact},
         {"shape", "time of a prototype, roundness by wear", print_shape}});
}
