// SPDX-License-Identifier: GPL-3.0-or-later
// Overlap queries per second, and the two methods side by side; medians of five runs, one thread.
#include "core/device.h"
#include "core/parallel.h"
#include "generators/layout/method.h"
#include "generators/layout/overlap.h"
#include "generators/sampling/region_shapes.h"
#include "generators/sampling/region_tools.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>

namespace {

using namespace scree;

constexpr int runs = 5;

/// Of this thread, so that a busy machine does not show; for work on other threads, by the clock.
double cpu_seconds_of(const auto& work) {
    const auto now = [] {
        timespec time{};
        clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
        return double(time.tv_sec) + 1e-9 * double(time.tv_nsec);
    };
    const double start = now();
    work();
    return now() - start;
}

double seconds_of(const auto& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

struct Case {
    std::string name;
    Ring ring;
    double domain; // side of the square domain, about the paper's counts in Table 1 [m]
};

LayoutProblem problem_of(const Case& c, double domain, std::uint64_t seed) {
    LayoutProblem problem{
        .domain = DomainTest(
            std::make_shared<Region>(triangulate({rectangle_ring(domain, domain)})), Inside::whole),
        .seed = seed};
    problem.shapes.emplace_back(triangulate({c.ring}));
    problem.weights = {1};
    return problem;
}

/// Pairs as a trial in a filled domain meets them: circumscribed circles that overlap.
void print_queries(const Case& c) {
    const CollisionShape shape(triangulate({c.ring}));
    struct Pair {
        Pose a, b;
        Vec2 offset;
    };
    std::vector<Pair> pairs;
    Random random(1, Purpose::test);
    while (pairs.size() < 4096) {
        const Vec2 offset(random.uniform(-2, 2) * shape.radius(),
                          random.uniform(-2, 2) * shape.radius());
        const Pose a(offset, random.uniform(0, 2 * pi), 1), b({0, 0}, random.uniform(0, 2 * pi), 1);
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
    fmt::print("{:10} {:8.2f} M queries/s, {:4.1f}% overlap, {} disks\n", c.name, median(rates),
               100.0 * double(hits) / double(pairs.size()) / repeats, shape.disks().size());
}

void print_methods(const Case& c, Device* device) {
    const auto print = [&](const char* method, const auto& fill) {
        std::vector<double> counts, seconds, queries;
        for (int run = 0; run < runs; ++run) {
            const LayoutProblem problem = problem_of(c, c.domain, std::uint64_t(run));
            Placements placements(problem);
            seconds.push_back(seconds_of([&] { fill(problem, placements); }));
            counts.push_back(double(placements.size()));
            queries.push_back(double(placements.queries()) / seconds.back() / 1e6);
        }
        const double area = std::abs(signed_area(c.ring)) / (c.domain * c.domain);
        fmt::print("{:10} {:20} {:6.0f} elements, fill {:.3f}, {:8.4f} s, {:6.2f} M queries/s\n",
                   c.name, method, median(counts), median(counts) * area, median(seconds),
                   median(queries));
    };
    print("naive 10,000", [](const LayoutProblem& problem, Placements& placements) {
        fill_naive(problem, 10000, placements, {});
    });
    print("naive 100,000", [](const LayoutProblem& problem, Placements& placements) {
        fill_naive(problem, 100000, placements, {});
    });
    print("fill_gap host", [](const LayoutProblem& problem, Placements& placements) {
        fill_gap(problem, {}, placements, {});
    });
    print("fill_gap device", [&](const LayoutProblem& problem, Placements& placements) {
        fill_gap(problem, {}, placements, {.device = device});
    });
}

void print_growth(const Case& c) {
    for (const double size : {10.0, 31.6, 100.0, 316.0}) {
        const LayoutProblem problem = problem_of(c, size, 1);
        Placements placements(problem);
        const double seconds = cpu_seconds_of([&] { fill_naive(problem, 1000, placements, {}); });
        fmt::print("{:10} naive 1,000 in {:5.0f} m: {:7} elements, {:7.2f} s, {:7.0f} elements/s\n",
                   c.name, size, placements.size(), seconds, double(placements.size()) / seconds);
    }
}

} // namespace

int main() {
    const ThreadLimit one_thread(1);
    const std::vector<Case> cases = {{"L", l_ring(1, 0.3), 15},
                                     {"star", star_ring(0.5, 0.4, 5), 15},
                                     {"chevron", chevron_ring(1, 0.25), 15},
                                     {"U", u_ring(1, 0.25), 15},
                                     {"square", rectangle_ring(1, 1), 15}};
    for (const Case& c : cases)
        print_queries(c);
    std::unique_ptr<Device> device;
    if (!Device::names().empty())
        device = std::make_unique<Device>();
    for (const Case& c : cases)
        print_methods(c, device.get());
    print_growth(cases[0]);
}
