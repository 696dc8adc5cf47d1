// SPDX-License-Identifier: GPL-3.0-or-later
// Benchmarks of generator.fibres: Tables 5.2 to 5.5 of Sakurai 2013 beside the figures in print,
// the balls of Table 5.6, what contact leaves by the number of fibres, and memory.
#include "bench/measure.h"
#include "bench/tables.h"
#include "core/parallel.h"
#include "formats/read_mesh.h"
#include "generators/table.h"
#include "session/stages.h"
#include "tests/support/fibres.h"

#include <cmath>
#include <cstdlib>
#include <map>
#include <span>

namespace {

using namespace scree;

using Values = std::map<std::string, Value>;

/// The mesh of a file, `size` [m] along its longest side; the thesis's lengths are tenths of a
/// bunny of size 2.
Value model(const std::string& file, double size) {
    Mesh mesh = read_mesh(file);
    normalise_size(mesh, size);
    return SharedObject(std::make_shared<const Mesh>(std::move(mesh)));
}

Value bunny(double size) { return model("/usr/share/glmark2/models/bunny.obj", size); }

/// One bake as C++ on the host.
struct Run {
    std::map<std::string, double> facts;
    double cpu = 0; // [s]
};

Run bake(const Values& values) {
    const Bake work = tests::make(generator_table(), "fibres", values);
    Run run;
    run.cpu = cpu_seconds_of([&] {
        for (const auto& [name, value] : work({}).facts)
            run.facts[name] = value;
    });
    return run;
}

Range in_degrees(double low, double high) { return {radians(low), radians(high)}; }

struct Row {
    const char* name;
    Range theta, phi; // [deg]
    double length;    // the bunny is 20 long
    std::int64_t count;
    int iterations = 0; // in print; 0: not given
    double seconds = 0; // of an iteration on a GTX 570
};

constexpr Row in_bunny[] = {{"5.2 a", {0, 0}, {0, 0}, 10, 2048, 35, 0.860},
                            {"5.2 b", {0, 10.8}, {0, 0}, 10, 2048, 54, 0.860},
                            {"5.2 c", {-10.8, 10.8}, {0, 0}, 10, 2048, 37, 0.860},
                            {"5.2 d", {0, 10.8}, {0, 36}, 10, 2048, 31, 0.835},
                            {"5.4 a", {0, 10.8}, {0, 36}, 20, 2048, 71, 0.863},
                            {"5.4 b", {0, 10.8}, {0, 36}, 5, 2048, 17, 0.859},
                            {"5.5 a", {0, 10.8}, {0, 36}, 10, 1024, 31, 0.444},
                            {"5.5 b", {0, 10.8}, {0, 36}, 10, 512, 32, 0.209}};

constexpr Row in_dragon[] = {{"5.3 a", {0, 0}, {0, 0}, 10, 2048, 28, 1.210},
                             {"5.3 b", {0, 10.8}, {0, 0}, 10, 2048, 37, 1.202},
                             {"5.3 c", {-10.8, 10.8}, {0, 0}, 10, 2048, 27, 1.217},
                             {"5.3 d", {0, 10.8}, {0, 36}, 10, 2048, 30, 1.201}};

constexpr Row in_ball[] = {{"5.12 b", {7.2, 14.4}, {7.2, 14.4}, 10, 2048},
                           {"5.12 c", {7.2, 14.4}, {7.2, 14.4}, 10, 512},
                           {"5.12 d", {7.2, 14.4}, {28.8, 43.2}, 10, 512},
                           {"5.12 e", {28.8, 36}, {7.2, 14.4}, 10, 512}};

void print_rows(const Value& target, std::span<const Row> rows) {
    for (const Row& row : rows) {
        if (row.iterations > 0)
            fmt::print("{:>6} {:>9} {:>8.3f}", row.name, row.iterations, row.seconds);
        else
            fmt::print("{:>6} {:>9} {:>8}", row.name, "-", "-");
        for (const char* method : {"thesis", "nearest"}) {
            const Run run = bake({{"target", target},
                                  {"adjustment", std::string(method)},
                                  {"theta", in_degrees(row.theta.low, row.theta.high)},
                                  {"phi", in_degrees(row.phi.low, row.phi.high)},
                                  {"length", Range{row.length / 10, row.length / 10}},
                                  {"radius", 0.004},
                                  {"count", row.count},
                                  {"contact", false}});
            const double iterations = run.facts.at("adjusting_iterations");
            fmt::print(" {:>9} {:>8.4f} {:>9}", iterations,
                       run.facts.at("adjusting_seconds") / std::max(1.0, iterations),
                       run.facts.at("outside_adjusted"));
        }
        fmt::print("\n");
    }
}

void print_tables() {
    fmt::print(
        "Adjustment in bunny, dragon and ball: iterations, seconds of an iteration, vertices "
        "outside\n");
    fmt::print("{:>6} {:>9} {:>8} {:>9} {:>8} {:>9} {:>9} {:>8} {:>9}\n", "table", "in print", "s",
               "thesis", "s", "outside", "nearest", "s", "outside");
    print_rows(bunny(2), in_bunny);
    if (const char* dragon = std::getenv("SCREE_DRAGON"))
        print_rows(model(dragon, 2), in_dragon);
    else
        fmt::print(
            "   5.3: SCREE_DRAGON=FILE names a closed mesh of the Stanford dragon, which is in "
            "no package of Debian\n");
    print_rows(tests::ball_target(1), in_ball);
}

/// Contact at 6.4% of the bunny, whose volume grows with the number of fibres.
void print_contact() {
    fmt::print("Contact in the bunny, 6.4% filled; depths in radii\n");
    fmt::print("{:>8} {:>10} {:>8} {:>8} {:>9} {:>8} {:>8} {:>12}\n", "fibres", "iterations",
               "deepest", "outside", "length", "CPU s", "s", "us a fibre");
    for (const std::int64_t count : {512, 2048, 8192, 32768, 100000}) {
        const Run run = bake({{"target", bunny(2 * std::cbrt(double(count) / 2048))},
                              {"length", Range{1, 1}},
                              {"count", count}});
        fmt::print("{:>8} {:>10} {:>8.4f} {:>8.4f} {:>9.1e} {:>8.2f} {:>8.2f} {:>12.0f}\n", count,
                   run.facts.at("contact_iterations"), run.facts.at("deepest"),
                   run.facts.at("outside"), run.facts.at("length_error"), run.cpu,
                   run.facts.at("seconds"), 1e6 * run.facts.at("seconds") / double(count));
    }
}

void print_memory() {
    fmt::print("Peak memory, bytes of a vertex above what a bake of one fibre needs\n");
    const Value target = bunny(2);
    for (const bool contact : {false, true}) {
        const auto at = [&](std::int64_t count) {
            Stages stages;
            stages.begin("bake");
            bake({{"target", target},
                  {"count", count},
                  {"radius", 0.0004},
                  {"segments", std::int64_t{32}},
                  {"max_iterations", std::int64_t{3}},
                  {"contact", contact}});
            stages.end();
            return stages.costs().back().peak_mib;
        };
        const double before = at(1);
        const std::int64_t count = contact ? 40000 : 200000;
        fmt::print("  {:14} {:>8} fibres {:>8.1f}\n", contact ? "contact" : "without contact",
                   count, (at(count) - before) * 1048576 / double(count * 33));
    }
}

} // namespace

int main(int count, char** arguments) {
    return bench::run_tables(count, arguments,
                             {{"memory", "bytes of a vertex", print_memory},
                              {"tables", "Tables 5.2 to 5.5, and the balls of 5.6", print_tables},
                              {"contact", "what contact leaves, by the number", print_contact}});
}
