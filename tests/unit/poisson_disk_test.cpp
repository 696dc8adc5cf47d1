// SPDX-License-Identifier: GPL-3.0-or-later
// Poisson-disk sets are distributed as random sequential adsorption is: against densities and
// probabilities that are known. Conflicts and coverage are tests/exact's.
#include "core/error.h"
#include "core/parallel.h"
#include "tests/support/disk_problems.h"

#include <gtest/gtest.h>

#include <numeric>

namespace scree::tests {
namespace {

/// Density at saturation of disks placed at random one by one, of which centres keep one diameter
/// apart: 0.5470735(28) (Torquato, Uche & Stillinger 2006; Zhang & Torquato 2013: 0.547067(3)).
constexpr double saturation = 0.54707;

/// Mean of numbers and its standard error, estimated from their variance.
struct Mean {
    double value = 0;
    double error = 0;
};

Mean mean_of(const std::vector<double>& values) {
    double sum = 0;
    double squares = 0;
    for (const double v : values)
        sum += v;
    const double count = double(values.size());
    for (const double v : values)
        squares += (v - sum / count) * (v - sum / count);
    return {sum / count, std::sqrt(squares / (count - 1) / count)};
}

/// Pearson's statistic against expectations in proportion to weights, or equal ones, in standard
/// deviations of its own distribution where counts are independent.
double chi_square_excess(const std::vector<double>& counts, std::vector<double> weights = {}) {
    double all = 0;
    for (const double c : counts)
        all += c;
    weights.resize(counts.size(), weights.empty() ? 1 : 0);
    const double all_weights = std::accumulate(weights.begin(), weights.end(), 0.0);
    double sum = 0;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const double expected = all * weights[i] / all_weights;
        sum += (counts[i] - expected) * (counts[i] - expected) / expected;
    }
    const double freedom = double(counts.size()) - 1;
    return (sum - freedom) / std::sqrt(2 * freedom);
}

PoissonDiskProblem torus_problem(double side, DiskClass disk, std::uint64_t seed) {
    PoissonDiskProblem problem;
    problem.domain = square_domain(side);
    problem.torus = true;
    problem.classes = {disk};
    problem.seed = seed;
    return problem;
}

std::size_t count_of(const PoissonDiskProblem& problem) {
    return sample_poisson_disks(problem, {}).samples.size();
}

TEST(ClassDistances, AreThoseOfWeisAlgorithmByHand) {
    const auto equal = [](const std::vector<double>& found, const std::vector<double>& expected) {
        ASSERT_EQ(found.size(), expected.size());
        for (std::size_t i = 0; i < found.size(); ++i)
            EXPECT_NEAR(found[i], expected[i], 1e-14) << i;
    };
    equal(class_distances({0.3}), {0.3});
    // D: 1/4, then 1/4 + 1 = 5/4.
    const double two = std::sqrt(0.8);
    equal(class_distances({2, 1}), {2, two, two, 1});
    equal(class_distances({1, 2}), {1, two, two, 2});
    // Equal ones are one group: D is 2/100, then 2/100 + 1/25 = 0.06.
    const double first = std::sqrt(50);
    const double second = std::sqrt(1 / 0.06);
    equal(class_distances({10, 5, 10}), {10, second, first, second, 5, second, first, second, 10});
    // Three groups: 1/16; + 1/4 = 5/16; + 1 = 21/16.
    const double a = std::sqrt(16.0 / 5);
    const double b = std::sqrt(16.0 / 21);
    equal(class_distances({4, 2, 1}), {4, a, b, a, 2, b, b, b, 1});
    // In space: 1/8 + 1 = 9/8.
    const double cube = std::cbrt(8.0 / 9);
    equal(class_distances({2, 1}, 3), {2, cube, cube, 1});
}

TEST(PoissonDisk, FillsATorusToTheSaturationOfRandomDisks) {
    constexpr double r = 1.0 / 200;
    std::vector<double> fills;
    for (std::uint64_t seed = 0; seed < 16; ++seed)
        fills.push_back(double(count_of(torus_problem(1, {r, r}, seed))) * pi * r * r / 4);
    const Mean fill = mean_of(fills);
    RecordProperty("fill", std::to_string(fill.value) + " +- " + std::to_string(fill.error));
    EXPECT_NEAR(fill.value, saturation, 4 * fill.error); // by chance once in 1000 (t, 15)
    // The count varies by 0.059 of its mean (the structure factor at 0), so that by chance the
    // error is beyond these once in 10,000.
    const double expected = saturation * std::sqrt(0.059 / (16 * 4 * saturation / (pi * r * r)));
    EXPECT_GT(fill.error, 0.4 * expected);
    EXPECT_LT(fill.error, 1.8 * expected);
    // The radius relative to that of the densest packing of as many points.
    const double relative = std::sqrt(2 * std::sqrt(3) * fill.value / pi);
    EXPECT_NEAR(relative, 0.7767, 0.0008);
}

/// An affine map takes ellipses of one direction to disks, and darts to darts.
TEST(PoissonDisk, EllipsesOfOneDirectionFillAsDisksDo) {
    for (const double direction : {0.0, 30.0}) {
        constexpr DiskClass axes{0.02, 0.005};
        std::vector<double> fills;
        for (std::uint64_t seed = 0; seed < 12; ++seed) {
            PoissonDiskProblem problem = torus_problem(1, axes, seed);
            problem.direction = std::make_shared<ConstantField>(direction);
            fills.push_back(double(count_of(problem)) * pi * axes.length * axes.width / 4);
        }
        const Mean fill = mean_of(fills);
        EXPECT_NEAR(fill.value, saturation, 4.5 * fill.error) << direction;
        EXPECT_LT(fill.error, 0.002);
    }
}

/// On a line darts leave Rényi's parking problem: with cars of length 1 on a street of length x
/// (centres on x - 1), the mean number is 3 - 2 / (x - 1) for x in [2, 3], and tends to
/// 0.7475979 x - 0.2524021 (Rényi 1958).
TEST(PoissonDisk, OnAStripIsTheParkingProblem) {
    const auto count = [](double length, std::uint64_t seed) {
        PoissonDiskProblem problem;
        problem.domain = shared_region({rectangle_ring(length, 1e-4)});
        problem.classes = {{1, 1}};
        problem.seed = seed;
        return double(count_of(problem));
    };
    std::vector<double> few;
    for (std::uint64_t seed = 0; seed < 3000; ++seed)
        few.push_back(count(1.5, seed));
    EXPECT_NEAR(mean_of(few).value, 3 - 2 / 1.5, 4 * mean_of(few).error);
    std::vector<double> many;
    for (std::uint64_t seed = 0; seed < 20; ++seed)
        many.push_back(count(1000, seed));
    EXPECT_NEAR(mean_of(many).value, 0.7475979 * 1001 - 0.2524021, 4.5 * mean_of(many).error);
    EXPECT_LT(mean_of(many).error, 3);
}

/// Where there is room for one sample only, it is uniformly distributed, and the probability of its
/// class is in proportion to the square of the area of the class's ellipse.
TEST(PoissonDisk, ASampleAloneLiesAnywhere) {
    // An L of three unit squares, which a grid cuts anyhow; all of it lies within the distances.
    constexpr double s = 0.1;
    const auto domain =
        shared_region({{{0, 0}, {2 * s, 0}, {2 * s, s}, {s, s}, {s, 2 * s}, {0, 2 * s}}});
    PoissonDiskProblem problem;
    problem.domain = domain;
    problem.classes = {{0.6, 0.6}, {0.4, 0.7}, {0.9, 0.9}};
    std::vector<double> cells(48);
    std::vector<double> classes(3);
    std::vector<double> turns(20);
    problem.classes[0].turn = {0, 2 * pi};
    for (std::uint64_t seed = 0; seed < 9000; ++seed) {
        problem.seed = seed;
        const PoissonDiskSet set = sample_poisson_disks(problem, {});
        ASSERT_EQ(set.samples.size(), 1U);
        const DiskSample& sample = set.samples[0];
        const Vec2 p = sample.position / (s / 4); // 4 x 4 cells in each square
        const auto x = static_cast<std::size_t>(p.x);
        const auto y = static_cast<std::size_t>(p.y);
        cells.at(y < 4 ? y * 8 + x : 32 + (y - 4) * 4 + x) += 1;
        classes[sample.disk_class] += 1;
        if (sample.disk_class == 0)
            turns[std::min<std::size_t>(19, std::size_t(sample.angle / (2 * pi) * 20))] += 1;
    }
    EXPECT_LT(chi_square_excess(cells), 4.5); // by chance once in 10,000
    std::vector<double> shares;
    for (const DiskClass& c : problem.classes)
        shares.push_back(c.length * c.width * c.length * c.width);
    EXPECT_LT(chi_square_excess(classes, shares), 8); // two degrees of freedom have a long tail
    EXPECT_LT(chi_square_excess(turns), 5);
}

/// Splitting slivers would never end if cutting restored the parts from before the split.
TEST(PoissonDisk, LongEllipsesInAWhirlComeToAnEnd) {
    PoissonDiskProblem problem;
    problem.domain = square_domain(1);
    problem.classes = {{0.13, 0.013}};
    problem.direction = std::make_shared<WhirlField>(Vec2(0, 0), 70);
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
        problem.seed = seed;
        const PoissonDiskSet set = sample_poisson_disks(problem, {});
        EXPECT_LT(set.trials, 100 * set.samples.size()) << seed;
    }
}

/// The least distance relative to that of the densest packing of as many points (Lagae & Dutré
/// 2008) grows: 0.777 for darts alone.
TEST(PoissonDisk, RelaxedDisksStandFartherApart) {
    PoissonDiskProblem problem;
    problem.domain = square_domain(1);
    problem.torus = true;
    problem.classes = {{0.02, 0.02}};
    for (const auto& [relax, least] : {std::pair{0, 0.76}, std::pair{100, 0.81}}) {
        problem.relax = relax;
        const std::vector<DiskSample> samples = sample_poisson_disks(problem, {}).samples;
        double nearest = 1;
        for (std::size_t i = 0; i < samples.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                Vec2 d = samples[i].position - samples[j].position;
                d -= Vec2(std::round(d.x), std::round(d.y));
                nearest = std::min(nearest, d.length());
            }
        const double densest = std::sqrt(2 / (std::sqrt(3) * double(samples.size())));
        EXPECT_GT(nearest / densest, least) << relax;
        EXPECT_EQ(relax == 0, nearest / densest < 0.79) << relax;
    }
}

/// Positions relative to grids, among them those a sampler may use inside.
TEST(PoissonDisk, NoGridShows) {
    constexpr double r = 1.0 / 150;
    std::vector<Vec2> points;
    for (std::uint64_t seed = 0; seed < 12; ++seed)
        for (const DiskSample& s : sample_poisson_disks(torus_problem(1, {r, r}, seed), {}).samples)
            points.push_back(s.position + Vec2(0.5, 0.5));
    const double cell = r / std::sqrt(2);
    for (const double step : {1 / std::ceil(1 / cell), 1 / std::floor(1 / cell), cell, cell / 2,
                              1 / std::ceil(1 / r), 1.0 / 256, 1.0 / 1024, 0.1, 1.0}) {
        constexpr std::size_t bins = 8;
        std::vector<double> in_cell(bins * bins);
        std::vector<double> along_x(32);
        std::vector<double> along_y(32);
        for (const Vec2& p : points) {
            const double x = p.x / step - std::floor(p.x / step);
            const double y = p.y / step - std::floor(p.y / step);
            in_cell[std::size_t(y * bins) * bins + std::size_t(x * bins)] += 1;
            along_x[std::size_t(x * 32)] += 1;
            along_y[std::size_t(y * 32)] += 1;
        }
        // Counts vary less than independent ones where bins are wider than r.
        EXPECT_LT(chi_square_excess(in_cell), 5) << step;
        EXPECT_LT(chi_square_excess(along_x), 5) << step;
        EXPECT_LT(chi_square_excess(along_y), 5) << step;
    }
}

TEST(PoissonDisk, ClassesOfOneRadiusAreEquallyMany) {
    PoissonDiskProblem problem = torus_problem(1, {0.03, 0.03}, 0);
    problem.classes.resize(3, problem.classes[0]);
    std::vector<double> differences;
    for (std::uint64_t seed = 0; seed < 16; ++seed) {
        problem.seed = seed;
        double difference = 0;
        for (const DiskSample& s : sample_poisson_disks(problem, {}).samples)
            difference += s.disk_class == 0 ? 1 : s.disk_class == 2 ? -1 : 0;
        differences.push_back(difference);
    }
    EXPECT_NEAR(mean_of(differences).value, 0, 4 * mean_of(differences).error);
}

bool same_samples(const PoissonDiskSet& a, const PoissonDiskSet& b) {
    if (a.samples.size() != b.samples.size() || a.trials != b.trials)
        return false;
    for (std::size_t i = 0; i < a.samples.size(); ++i) {
        const DiskSample& s = a.samples[i];
        const DiskSample& t = b.samples[i];
        if (s.position != t.position || s.disk_class != t.disk_class || s.angle != t.angle ||
            s.scale != t.scale)
            return false;
    }
    return true;
}

TEST(PoissonDisk, IsTheSameOnAnyNumberOfThreads) {
    for (const Mode mode : all_modes())
        for (const bool torus : {false, true}) {
            PoissonDiskProblem problem =
                problem_of(mode, torus ? square_domain(1) : pierced_domain(), 0.02, 9);
            problem.torus = torus;
            const auto run = [&](int threads) {
                const ThreadLimit limit(threads);
                return sample_poisson_disks(problem, {});
            };
            const PoissonDiskSet one = run(1);
            EXPECT_TRUE(same_samples(one, run(2))) << name_of(mode);
            EXPECT_TRUE(same_samples(one, run(7))) << name_of(mode);
            problem.seed = 10;
            EXPECT_FALSE(same_samples(one, run(2))) << name_of(mode);
        }
}

TEST(PoissonDisk, AFullSetTakesNoMore) {
    for (const Mode mode : all_modes()) {
        PoissonDiskProblem problem = problem_of(mode, pierced_domain(), 0.02, 11);
        problem.kept = sample_poisson_disks(problem, {}).samples;
        problem.seed = 12;
        EXPECT_TRUE(sample_poisson_disks(problem, {}).samples.empty()) << name_of(mode);
    }
}

TEST(PoissonDisk, CanBeCancelledAtOnceAndOnTheWay) {
    for (const Mode mode : all_modes()) {
        const PoissonDiskProblem problem = problem_of(mode, square_domain(1), 0.004, 13);
        Cancel before;
        before.request();
        EXPECT_THROW(sample_poisson_disks(problem, {.cancel = &before}), Cancelled);
        Cancel midway;
        double reached = 0;
        const Progress stop = [&](std::string_view, double fraction) {
            reached = std::max(reached, fraction);
            midway.request();
        };
        EXPECT_THROW(sample_poisson_disks(problem, {.cancel = &midway, .progress = stop}),
                     Cancelled)
            << name_of(mode);
        EXPECT_LT(reached, 0.9) << name_of(mode);
    }
}

TEST(PoissonDisk, RefusesATorusNarrowerThanFourReaches) {
    EXPECT_THROW(sample_poisson_disks(torus_problem(1, {0.26, 0.26}, 1), {}), Error);
    EXPECT_THROW(sample_poisson_disks(torus_problem(1, {0.26, 0.02}, 1), {}), Error);
    PoissonDiskProblem scaled = torus_problem(1, {0.2, 0.2}, 1);
    scaled.scale = std::make_shared<ConstantField>(1.3);
    EXPECT_THROW(sample_poisson_disks(scaled, {}), Error);
    EXPECT_GT(count_of(torus_problem(1, {0.24, 0.24}, 1)), 4U);
}

} // namespace
} // namespace scree::tests
