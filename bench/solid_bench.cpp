// SPDX-License-Identifier: GPL-3.0-or-later
// Benchmarks of solid textures: construction of lattices, and evaluations per second compared with
// the limit set by the machine's gathers. One thread, CPU time, medians of interleaved runs.
//   solid_bench [lattices|throughput ...]     all by default
#include "bench/gather_limit.h"
#include "bench/measure.h"
#include "bench/solid_pictures.h"
#include "bench/tables.h"
#include "core/parallel.h"
#include "core/random.h"
#include "procedurals/solid/lattice/fractal_lattice.h"
#include "procedurals/solid/lattice/vector_path.h"
#include "procedurals/solid/marble/stripes.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <set>

namespace {

using namespace scree;

constexpr int runs = 15;

/// Work to measure. The runs of all rows are interleaved, so that changes of the machine's load
/// affect them equally.
struct Row {
    std::string name;
    std::string path; // one of vector_paths(), if it matters
    std::function<void()> work;
    std::vector<double> seconds = {};
};

void measure(std::vector<Row>& rows, int repeats) {
    for (int run = -1; run < runs; ++run) // once to warm up
        for (Row& row : rows) {
            const UseVectorPath path(row.path);
            const double seconds = cpu_seconds_of([&] {
                for (int i = 0; i < repeats; ++i)
                    row.work();
            });
            if (run >= 0)
                row.seconds.push_back(seconds / repeats);
        }
}

LatticeSettings settings_of(int levels, bool sixteen_bit) {
    LatticeSettings settings;
    settings.levels = levels;
    settings.sixteen_bit = sixteen_bit;
    return settings;
}

/// Construction of a lattice, compared with writing as many floats into new memory.
void print_lattices() {
    fmt::print("{:6} {:12} {:>10} {:>10} {:>12}\n", "nodes", "path", "ms", "ns/node", "of filling");
    for (const int levels : {6, 7, 8}) {
        const std::size_t side = (std::size_t(1) << levels) + 1, nodes = side * side * side;
        std::vector<Row> rows = {{"filling", "", [nodes] {
                                      const auto floats = large_array<float>(nodes);
                                      std::fill_n(floats.get(), nodes, 1.0F);
                                  }}};
        for (const std::string& path : vector_paths())
            for (const bool sixteen_bit : {true, false})
                if (path != "scalar" || levels < 8)
                    rows.push_back({path + (sixteen_bit ? " 16" : " 32"), path, [=] {
                                        const FractalLattice made(settings_of(levels, sixteen_bit));
                                    }});
        measure(rows, 1);
        for (const Row& row : rows)
            fmt::print("{:4}^3 {:12} {:10.2f} {:10.2f} {:12.1f}\n", side, row.name,
                       median(row.seconds) * 1e3, median(row.seconds) / double(nodes) * 1e9,
                       median(row.seconds) / median(rows[0].seconds));
    }
}

/// Points of the unit cube, few enough to stay in the L2 cache with their results: rows of a slice
/// of 512^2 pixels, or random points.
struct Points {
    static constexpr int width = 512, rows = 32;
    std::vector<float> x, y, z;

    explicit Points(bool coherent) {
        Random random(1, Purpose::test);
        const auto one = [&] { return random.uniform_float(); };
        for (int row = 0; row < rows; ++row)
            for (int column = 0; column < width; ++column) {
                const float u = static_cast<float>(column) / width;
                const float v = static_cast<float>(row) / rows;
                x.push_back(coherent ? u : one());
                y.push_back(coherent ? 0.3F + 0.1F * v : one());
                z.push_back(coherent ? v : one());
            }
    }
    std::size_t size() const { return x.size(); }
};

/// Six irregularly placed veins with the diffusion of fig. 10.
std::vector<solid::Vein> six_veins() {
    std::vector<solid::Vein> veins;
    for (const float centre : {0.08F, 0.22F, 0.41F, 0.55F, 0.73F, 0.91F}) {
        solid::Vein vein{};
        vein.centre = centre;
        vein.half_width = 0.01F;
        vein.rate = 40 + 30 * centre;
        veins.push_back(vein);
    }
    return veins;
}

/// Evaluations per second, compared with eight gathers per sample from a table with as many words
/// as there are nodes.
void print_throughput() {
    for (const int levels : {6, 7})
        for (const bool coherent : {true, false}) {
            const Points points(coherent);
            const FractalLattice lattice(settings_of(levels, true));
            const LatticeQuads quads(lattice);
            const int side = lattice.side() + 1;
            std::vector<float> table(static_cast<std::size_t>(side) *
                                         static_cast<std::size_t>(side) *
                                         static_cast<std::size_t>(side),
                                     1);
            std::vector<float> out(points.size());
            std::vector<std::int32_t> first;
            for (std::size_t i = 0; i < points.size(); ++i) {
                const auto cell = [&](float v) {
                    return static_cast<int>(v * static_cast<float>(lattice.side()));
                };
                first.push_back(cell(points.x[i]) +
                                side * (cell(points.y[i]) + side * cell(points.z[i])));
            }
            const std::int32_t offsets[8] = {0,
                                             1,
                                             side,
                                             side + 1,
                                             side * side,
                                             side * side + 1,
                                             side * side + side,
                                             side * side + side + 1};
            const std::vector<solid::Vein> veins = six_veins();
            const VeinTable table_of_veins(veins, 0);
            const PlainWood wood{0.5F, 0.5F, 12, 0.025F};

            std::vector<Row> rows;
            for (const bench::Gather& gather : bench::gathers())
                rows.push_back(
                    {gather.name, "", [&, gather] { gather.run(table, first, offsets, out); }});
            const std::size_t limits = rows.size();
            const auto& [x, y, z] = points;
            for (const std::string& path : vector_paths()) {
                rows.push_back({path + " D", path, [&] { quads.fluctuations(x, y, z, out); }});
                rows.push_back({path + " marble", path, [&] {
                                    marble_values(quads, table_of_veins, 0.25F, x, y, z, out);
                                }});
                rows.push_back(
                    {path + " wood", path, [&] { wood_values(quads, wood, x, y, z, out); }});
            }
            measure(rows, 40);
            double limit = 0;
            fmt::print("{}^3, {} points: 10^6 evaluations a second, and of the limit\n", side,
                       coherent ? "coherent" : "random");
            for (std::size_t i = 0; i < rows.size(); ++i) {
                const double rate = double(points.size()) / median(rows[i].seconds);
                if (i < limits)
                    limit = std::max(limit, rate);
                fmt::print("  {:24} {:8.1f} {:8.2f}\n", rows[i].name, rate * 1e-6, rate / limit);
            }
        }
}

} // namespace

int main(int count, char** arguments) {
    const auto alone = [](void (*print)()) {
        return [print] {
            const ThreadLimit one_thread(1);
            print();
        };
    };
    return bench::run_tables(
        count, arguments,
        {{"lattices", "how long lattices take to make", print_lattices},
         {"throughput", "points per second, of the limit of gathering", print_throughput},
         {"antialiasing", "errors of a pixel of 8 cells", alone(bench::print_antialiasing)},
         {"floor", "errors of a marble floor by rows", alone(bench::print_floor)},
         {"shading", "cost of textures in a render", alone(bench::print_shading)},
         {"table", "Table 1 of Okada et al. (1987)", alone(bench::print_table_1)}});
}
