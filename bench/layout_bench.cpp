// SPDX-License-Identifier: GPL-3.0-or-later
// Benchmarks of generator.layout: overlap queries, comparison of the methods, the paper's figures
// 5, 7, 10 and 11 and its table 1, and scaling with the number of elements. One thread unless
// stated; medians of five runs.
//   layout_bench [queries|methods|figures|candidates|table|growth ...]     all by default
#include "bench/measure.h"
#include "bench/tables.h"
#include "core/device.h"
#include "core/parallel.h"
#include "generators/layout/gap_field.h"
#include "generators/layout/method.h"
#include "geometry/figures/overlap.h"
#include "geometry/plane/region_shapes.h"
#include "geometry/plane/region_tools.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <set>

#include <sys/resource.h>

namespace {

using namespace scree;

constexpr int runs = 5;

double seconds_of(const auto& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

struct Shape {
    std::string name;
    std::vector<Ring> rings; // one per component
    double domain = 15;      // side of the square domain [m]
    Range scale{1, 1};
};

/// A lobed outline, as that of the paper's trees seen from above.
Ring tree_ring(double radius, int lobes) {
    Ring ring;
    for (int i = 0; i < 6 * lobes; ++i) {
        const double angle = 2 * pi * i / (6 * lobes);
        ring.push_back(rotate({radius * (0.85 + 0.15 * std::cos(lobes * angle)), 0}, angle));
    }
    return ring;
}

std::vector<Shape> shapes() {
    return {{"L", {l_ring(1, 0.3)}},
            {"star", {star_ring(0.5, 0.4, 5)}},
            {"chevron", {chevron_ring(1, 0.25)}},
            {"U", {u_ring(1, 0.25)}},
            {"square", {rectangle_ring(1, 1)}}};
}

/// Cases like those of the paper's table 1. The paper does not give its components as numbers;
/// these are concave ones of three kinds, in domains that give about its counts.
std::vector<Shape> table_cases() {
    return {{"(a) E1: L", {l_ring(1, 0.3)}, 20.5},
            {"(b) E2: U", {u_ring(1, 0.25)}, 10.2},
            {"(c) E3: chevron", {chevron_ring(1, 0.25)}, 6.5},
            {"(d) trees", {tree_ring(0.5, 5), tree_ring(0.45, 7)}, 5.4, {0.2, 1.0}},
            {"Fig. 1(b) mixed", {l_ring(1, 0.3), u_ring(1, 0.25), chevron_ring(1, 0.25)}, 15.2}};
}

LayoutProblem problem_of(const Shape& shape, double domain, std::uint64_t seed,
                         Inside inside = Inside::whole) {
    LayoutProblem problem{
        .domain = DomainTest(
            std::make_shared<Region>(triangulate({rectangle_ring(domain, domain)})), inside),
        .scale = shape.scale,
        .seed = seed};
    for (const Ring& ring : shape.rings) {
        problem.shapes.emplace_back(triangulate({ring}));
        problem.weights.push_back(1);
    }
    return problem;
}

double fill_of(const LayoutProblem& problem, const Placements& placements) {
    double sum = 0;
    for (const Dart& dart : placements.darts())
        sum += problem.shapes[dart.component].area() * dart.pose.scale * dart.pose.scale;
    return sum / area(problem.domain.region());
}

/// Pairs with overlapping circumscribed circles, as tested in trials in a filled domain.
void print_queries(const Shape& s) {
    const CollisionShape shape(triangulate({s.rings[0]}));
    struct Pair {
        FigurePose a, b;
        Vec2 offset;
    };
    std::vector<Pair> pairs;
    Random random(1, Purpose::test);
    while (pairs.size() < 4096) {
        const Vec2 offset(random.uniform(-2, 2) * shape.radius(),
                          random.uniform(-2, 2) * shape.radius());
        const FigurePose a(offset, random.uniform(0, 2 * pi), 1),
            b({0, 0}, random.uniform(0, 2 * pi), 1);
        if (offset.length() < 2 * shape.radius())
            pairs.push_back({a, b, offset});
    }
    std::size_t hits = 0;
    constexpr int repeats = 200;
    std::vector<double> rates;
    for (int run = 0; run < runs; ++run) {
        hits = 0;
        const double seconds = cpu_seconds_of([&] {
            for (int i = 0; i < repeats; ++i)
                for (const Pair& pair : pairs)
                    hits += overlap(shape, pair.a, shape, pair.b, pair.offset) ? 1 : 0;
        });
        rates.push_back(double(pairs.size()) * repeats / seconds / 1e6);
    }
    fmt::print("{:10} {:8.2f} M queries/s, {:4.1f}% overlap, {} disks\n", s.name, median(rates),
               100.0 * double(hits) / double(pairs.size()) / repeats, shape.disks().size());
}

struct Row {
    double count = 0, fill = 0, seconds = 0, trials = 0, rate = 0;
};

/// Medians over runs with different seeds; `fill` returns the number of trials.
Row measure(const Shape& shape, const auto& fill, Inside inside = Inside::whole) {
    std::vector<double> counts, fills, seconds, trials;
    for (int run = 0; run < runs; ++run) {
        const LayoutProblem problem = problem_of(shape, shape.domain, std::uint64_t(run), inside);
        Placements placements(problem);
        MethodCounts made;
        seconds.push_back(cpu_seconds_of([&] { made = fill(problem, placements); }));
        counts.push_back(double(placements.size()));
        fills.push_back(fill_of(problem, placements));
        trials.push_back(double(made.trials));
    }
    Row row{median(counts), median(fills), median(seconds), median(trials), 0};
    row.rate = row.count / row.seconds;
    return row;
}

void print_row(const std::string& name, const std::string& method, const Row& row,
               const Row& reference) {
    fmt::print("{:16} {:18} {:7.0f} {:7.3f} {:10.4f} {:11.0f} {:10.0f} {:9.3f} {:9.3f}\n", name,
               method, row.count, row.fill, row.seconds, row.trials, row.rate,
               row.count / reference.count, row.seconds / reference.seconds);
}

void print_header(const std::string& reference) {
    fmt::print("{:16} {:18} {:>7} {:>7} {:>10} {:>11} {:>10} {:>9} {:>9}  (ratios to {})\n", "",
               "method", "count", "fill", "CPU s", "trials", "per CPU s", "count", "time",
               reference);
}

MethodCounts saturate(const LayoutProblem& problem, Placements& placements, double share,
                      Certificate* out = nullptr) {
    Certificate certificate;
    const MethodCounts counts = fill_saturated(
        problem, {.epsilon = share * problem.smallest_inner_radius()}, placements, certificate, {});
    if (certificate.undecided > 0)
        fmt::print("! {} undecided\n", certificate.undecided);
    if (out != nullptr)
        *out = certificate;
    return counts;
}

void print_methods(const Shape& shape, Device* device) {
    const Row million = measure(shape, [](const LayoutProblem& problem, Placements& placements) {
        return fill_naive(problem, 1000000, placements, {});
    });
    print_row(shape.name, "naive 1,000,000", million, million);
    for (const std::uint64_t cancellations : {10000, 100000})
        print_row(shape.name, fmt::format("naive {}", cancellations),
                  measure(shape,
                          [&](const LayoutProblem& problem, Placements& placements) {
                              return fill_naive(problem, cancellations, placements, {});
                          }),
                  million);
    for (Device* const d : {static_cast<Device*>(nullptr), device})
        print_row(shape.name, d == nullptr ? "fill_gap host" : "fill_gap device",
                  measure(shape,
                          [&](const LayoutProblem& problem, Placements& placements) {
                              return fill_gap(problem, {}, placements, {.device = d});
                          }),
                  million);
    print_row(
        shape.name, "saturated 1%",
        measure(shape, [](const LayoutProblem& problem,
                          Placements& placements) { return saturate(problem, placements, 0.01); }),
        million);
}

/// On a torus, as in RSA3D, without losses at a border.
void print_torus_fill(const Shape& shape) {
    Shape large = shape;
    large.domain = 40;
    const Row row = measure(
        large,
        [](const LayoutProblem& problem, Placements& placements) {
            return saturate(problem, placements, 0.01);
        },
        Inside::torus);
    fmt::print("{:10} saturated 1% on a torus of 40 m: {:6.0f} elements, fill {:.4f}, {:.0f} per "
               "CPU s\n",
               shape.name, row.count, row.fill, row.rate);
}

/// Figures 5 and 7: elements and time by the number of consecutive rejections that ends the run.
void print_cancellations(const Shape& shape) {
    for (const std::uint64_t cancellations : {50, 200, 500, 1000, 2000, 5000, 7000, 10000}) {
        const Row row = measure(shape, [&](const LayoutProblem& problem, Placements& placements) {
            return fill_naive(problem, cancellations, placements, {});
        });
        fmt::print("{:16} naive {:6}: {:6.0f} elements, {:.4f} s\n", shape.name, cancellations,
                   row.count, row.seconds);
    }
}

/// Figures 10 and 11: the number of points Q for each exponent, and their distance from placed
/// elements as a share of the largest distance.
void print_candidates() {
    const Shape shape = shapes()[0];
    const LayoutProblem problem = problem_of(shape, shape.domain, 1);
    Placements placements(problem);
    fill_naive(problem, 300, placements, {});
    for (const std::uint32_t exponent : {1U, 2U, 4U, 8U, 16U, 32U}) {
        GapField field(problem.domain, 512, nullptr);
        for (const Dart& dart : placements.darts())
            field.occupy(problem.shapes[dart.component].outline(), dart.pose);
        const std::vector<Vec2> points = field.candidates(exponent, 1, 0);
        double sum = 0, count = 0, largest = 0;
        for (std::size_t i = 0; i < field.marks().size(); ++i) {
            const double distance = std::sqrt(double(field.squared_distance()[i]));
            if (field.state()[i] == 0)
                largest = std::max(largest, distance);
            if (field.marks()[i] != 0) {
                sum += distance;
                ++count;
            }
        }
        fmt::print("exponent {:3}: {:7} points Q, mean distance {:.3f} of the largest\n", exponent,
                   points.size(), sum / count / largest);
    }
}

/// Table 1 and figure 1(b), with the paper's numbers.
void print_table() {
    struct Paper {
        double fill_gap_seconds, fill_gap_count, naive_seconds, naive_count;
    };
    const std::vector<Paper> paper = {{17.2, 321, 316.2, 323},
                                      {11.5, 64, 93.3, 61},
                                      {13.2, 58, 177.8, 61},
                                      {31.5, 244, 488.0, 258},
                                      {18.3, 224, 250, 210}};
    fmt::print("{:16} | paper, 2009 desktop: fill-gap, naive | ours: fill_gap, naive 10,000, "
               "saturated 1% (count, CPU s)\n",
               "");
    for (std::size_t i = 0; i < paper.size(); ++i) {
        const Shape shape = table_cases()[i];
        const Row gap = measure(shape, [](const LayoutProblem& problem, Placements& placements) {
            return fill_gap(problem, {}, placements, {});
        });
        const Row naive = measure(shape, [](const LayoutProblem& problem, Placements& placements) {
            return fill_naive(problem, 10000, placements, {});
        });
        const Row full = measure(shape, [](const LayoutProblem& problem, Placements& placements) {
            return saturate(problem, placements, 0.01);
        });
        const Paper& p = paper[i];
        fmt::print("{:16} | {:4.0f} in {:5.1f} s, {:4.0f} in {:5.1f} s | {:4.0f} in {:.4f} s, "
                   "{:4.0f} in {:.4f} s, {:4.0f} in {:.4f} s\n",
                   shape.name, p.fill_gap_count, p.fill_gap_seconds, p.naive_count, p.naive_seconds,
                   gap.count, gap.seconds, naive.count, naive.seconds, full.count, full.seconds);
    }
}

/// Three concave kinds together, on all threads, saturated at 2%.
void print_growth() {
    const Shape mixed = table_cases().back();
    double first = 0;
    for (const double domain : {32.6, 103.0, 326.0}) {
        const LayoutProblem problem = problem_of(mixed, domain, 1);
        Placements placements(problem);
        Certificate certificate;
        double cpu = 0;
        const double wall = seconds_of([&] {
            cpu = cpu_seconds_of([&] { saturate(problem, placements, 0.02, &certificate); });
        });
        rusage usage{};
        getrusage(RUSAGE_SELF, &usage);
        const double each = cpu / double(placements.size());
        first = first == 0 ? each : first;
        fmt::print("mixed, saturated 2%, {:2} threads: {:8} elements, fill {:.4f}, {:8.2f} s, CPU "
                   "{:8.2f} s, {:.3f} ms each ({:.2f} of the first), {} undecided, peak {} MiB\n",
                   thread_count(), placements.size(), fill_of(problem, placements), wall, cpu,
                   each * 1e3, each / first, certificate.undecided, usage.ru_maxrss / 1024);
    }
}

void print_all_queries() {
    for (const Shape& shape : shapes())
        print_queries(shape);
}

void print_all_methods() {
    std::unique_ptr<Device> device;
    if (!Device::names().empty())
        device = std::make_unique<Device>();
    print_header("naive 1,000,000");
    for (const Shape& shape : shapes())
        print_methods(shape, device.get());
    for (const Shape& shape : shapes())
        print_torus_fill(shape);
}

void print_figures() {
    print_cancellations(table_cases().back());
    for (std::size_t i = 0; i < 3; ++i)
        print_cancellations(table_cases()[i]);
}

/// On one thread.
std::function<void()> alone(void (*print)()) {
    return [print] {
        const ThreadLimit one_thread(1);
        print();
    };
}

} // namespace

int main(int count, char** arguments) {
    return bench::run_tables(
        count, arguments,
        {{"queries", "time of an overlap test by shape", alone(print_all_queries)},
         {"methods", "naive, fill_gap and saturated: count and time", alone(print_all_methods)},
         {"figures", "counts by cancellations (Sakurai & Miyata 2014)", alone(print_figures)},
         {"candidates", "what the candidates of fill_gap bring", alone(print_candidates)},
         {"table", "the paper's table", alone(print_table)},
         {"growth", "time by the number of elements, on all threads", print_growth}});
}
