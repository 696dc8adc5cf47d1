// SPDX-License-Identifier: GPL-3.0-or-later
// Benchmarks of generator.elements: points per second on one core by number of points, how many of
// a million random darts still fit, small sets and refilled holes, table 1 of Kita & Miyata (2012),
// and other programs for the same task. CPU seconds of the whole process; medians of five runs, or
// of fewer when they take more than 12 s.
//   elements_bench [modes|small|table|peers ...]     all by default
#include "bench/measure.h"
#include "bench/peers.h"
#include "bench/tables.h"
#include "core/parallel.h"
#include "core/random.h"
#include "scenes/reader/description.h"
#include "session/session.h"
#include "tests/exact/disk_set.h"
#include "tests/support/disk_problems.h"

#include <fmt/format.h>

#include <cstdio>
#include <set>

namespace {

using namespace scree;

constexpr std::size_t darts = 1000000;

/// A kind of sample set in the unit square; axes are relative.
struct Kind {
    std::string name;
    std::vector<DiskClass> classes;
    bool whirl = false;
    bool torus = false;
    int relax = 0;
};

std::vector<Kind> kinds() {
    return {
        {"isotropic", {{1, 1}}},
        {"isotropic, torus", {{1, 1}}, false, true},
        {"isotropic, relaxed", {{1, 1}}, false, false, 10},
        {"anisotropic whirl 2:1", {{1.4, 0.7}}, true},
        {"anisotropic whirl 4:1", {{2, 0.5}}, true},
        {"ellipses any way 2:1", {{1.4, 0.7, {0, 2 * pi}}}},
        {"four classes of one size", {{1, 1}, {1, 1}, {1, 1}, {1, 1}}},
        {"four classes, 1 to 2.5", {{2.5, 2.5}, {1.6, 1.6}, {1, 1}, {1, 1}}},
        {"three classes, whirl", {{2.4, 1.2}, {1.5, 0.5}, {1, 1}}, true},
    };
}

PoissonDiskProblem problem_of(const Kind& kind, double size, std::uint64_t seed) {
    PoissonDiskProblem problem;
    problem.domain = tests::square_domain(1);
    problem.torus = kind.torus;
    problem.relax = kind.relax;
    problem.seed = seed;
    for (DiskClass c : kind.classes) {
        c.length *= size;
        c.width *= size;
        problem.classes.push_back(c);
    }
    if (kind.whirl)
        problem.direction = std::make_shared<WhirlField>(Vec2(0, 0), 70);
    return problem;
}

/// The size at which about `count` samples fill the square.
double size_for(const Kind& kind, double count) {
    double size = 0.02;
    for (int i = 0; i < 2; ++i) // iterated, since the border effect depends on the size
        size *=
            std::sqrt(double(sample_poisson_disks(problem_of(kind, size, 99), {}).samples.size()) /
                      std::min(count, i == 0 ? 20000. : count));
    return size;
}

/// The number of random darts that conflict with no sample.
std::size_t count_fitting(const PoissonDiskProblem& problem,
                          const std::vector<DiskSample>& samples) {
    const tests::DiskSet set(problem, samples);
    Random random(1, Purpose::test);
    std::size_t fitting = 0;
    for (std::size_t i = 0; i < darts; ++i) {
        const Vec2 point(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5));
        const auto k = static_cast<std::uint32_t>(i % problem.classes.size());
        fitting += set.margin(set.sample(point, k, random.uniform())) >= 1 ? 1 : 0;
    }
    return fitting;
}

/// The radius relative to that of the densest packing of as many points (Lagae & Dutre 2008).
double relative_radius(double radius, std::size_t count) {
    return radius / std::sqrt(2 / (std::sqrt(3) * double(count)));
}

void print_modes() {
    fmt::print("{:26} {:>9} {:>10} {:>9} {:>10} {:>8} {:>8} {:>9}\n", "the unit square, one core",
               "points", "points/s", "CPU s", "trials/pt", "unres.", "fitting", "rel. rad.");
    for (const Kind& kind : kinds())
        for (const double count : {1e4, 1e5, 1e6}) {
            const double size = size_for(kind, count);
            std::vector<double> seconds;
            PoissonDiskProblem problem;
            PoissonDiskSet set;
            for (std::uint64_t seed = 1;
                 seed <= 5 && (seconds.empty() || seconds.back() * double(seed) < 12); ++seed) {
                problem = problem_of(kind, size, seed);
                seconds.push_back(cpu_seconds_of([&] { set = sample_poisson_disks(problem, {}); }));
            }
            const double each = median(seconds);
            const DiskClass& axes = problem.classes[0];
            fmt::print("{:26} {:9} {:10.0f} {:9.3f} {:10.2f} {:8} {:8}", kind.name,
                       set.samples.size(), double(set.samples.size()) / each, each,
                       double(set.trials) / double(set.samples.size()), set.unresolved,
                       count_fitting(problem, set.samples));
            if (problem.classes.size() == 1)
                fmt::print(" {:9.4f}", relative_radius(std::sqrt(axes.length * axes.width),
                                                       set.samples.size()));
            fmt::print("\n");
        }
}

void print_small() {
    for (const Kind& kind : kinds()) {
        const double size = size_for(kind, 500);
        std::vector<double> fill, hole;
        std::size_t removed = 0;
        for (std::uint64_t seed = 1; seed <= 15; ++seed) {
            PoissonDiskProblem problem = problem_of(kind, size, seed);
            PoissonDiskSet set;
            fill.push_back(cpu_seconds_of([&] { set = sample_poisson_disks(problem, {}); }));
            for (const DiskSample& s : set.samples)
                if (s.position.length() > 0.15)
                    problem.kept.push_back(s);
            removed = set.samples.size() - problem.kept.size();
            const double reach = 0.15 + 2.5 * size;
            problem.window = Box2(Vec2(-reach), Vec2(reach));
            problem.relax = 0;
            hole.push_back(cpu_seconds_of([&] { sample_poisson_disks(problem, {}); }));
        }
        const auto text = [](const std::vector<double>& seconds) {
            return fmt::format("{:6.2f} ms (at most {:6.2f})", 1e3 * median(seconds),
                               1e3 * std::ranges::max(seconds));
        };
        fmt::print("{:26} 500 points in {}; a hole of {} of them refilled in {}\n", kind.name,
                   text(fill), removed, text(hole));
    }
}

/// Table 1: pine needles of three classes, random directions and a whirl.
void print_table() {
    const std::string path = std::string(SCREE_SOURCE_DIR) + "/scenes/elements_matsuba.lua";
    for (const auto& [direction, paper] : {std::pair("random", "332 of 24,482 trials in 38.1 ms"),
                                           std::pair("whirl", "297 of 24,482 trials in 59.8 ms")}) {
        Session session({.path = path, .overrides = {{"direction", direction}}, .device = "none"});
        for (const auto& item : session.load().items) {
            if (item->kind == "object")
                continue;
            fmt::print("table 1, {:6} paper: {}, shares 0.3 0.3 0.4; ours:", direction, paper);
            for (const auto& [name, value] : item->bake({}, 0).facts)
                fmt::print(" {} {:.4g}", name, value);
            fmt::print("\n");
        }
    }
}

void print_peer(const std::string& name, double radius, double seconds,
                const std::vector<DiskSample>& samples) {
    PoissonDiskProblem problem = problem_of({"", {{1, 1}}}, radius, 1);
    const std::size_t fitting = count_fitting(problem, samples);
    problem.kept = samples;
    const double missing = double(sample_poisson_disks(problem, {}).samples.size());
    fmt::print("{:36} {:9} {:10.0f} {:9.3f} {:9.4f} {:8} {:7.2f}%\n", name, samples.size(),
               double(samples.size()) / seconds, seconds, relative_radius(radius, samples.size()),
               fitting, 100 * missing / (missing + double(samples.size())));
}

void print_peers() {
    fmt::print("{:36} {:>9} {:>10} {:>9} {:>9} {:>8} {:>8}\n", "the unit square, one distance",
               "points", "points/s", "CPU s", "rel. rad.", "fitting", "missing");
    const Kind round = kinds()[0];
    for (const int count : {10000, 100000, 1000000}) {
        const double radius = size_for(round, count);
        PoissonDiskSet set;
        const double seconds =
            cpu_seconds_of([&] { set = sample_poisson_disks(problem_of(round, radius, 1), {}); });
        print_peer("scree", radius, seconds, set.samples);
        for (const bench::Peer& peer : bench::elements_peers()) {
            if (count > peer.most)
                continue;
            const auto run = bench::run(peer, radius);
            if (!run) {
                fmt::print("{:36} is not installed (bench/peers/README.md)\n", peer.name);
                continue;
            }
            std::vector<DiskSample> samples;
            for (const Vec2& p : run->points)
                samples.push_back({p - Vec2(0.5), 0, 0, 1});
            print_peer(peer.name, radius, run->seconds, samples);
        }
    }
}

} // namespace

int main(int count, char** arguments) {
    const ThreadLimit one_thread(1);
    return bench::run_tables(
        count, arguments,
        {{"modes", "samples per second by kind of set, and what is left uncovered", print_modes},
         {"small", "sets of 500 samples, and the refilling of a hole", print_small},
         {"table", "Table 1 of Kita & Miyata (2012)", print_table},
         {"peers", "other programs' sets, where they are installed", print_peers}});
}
