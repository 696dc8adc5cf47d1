// SPDX-License-Identifier: GPL-3.0-or-later
// Poisson-disk sets have no conflicts and no room for another sample: by exact arithmetic for
// disks, by dense probing for ellipses.
#include "shapes/field/grid_field.h"
#include "tests/exact/coverage.h"
#include "tests/exact/insertion.h"
#include "tests/support/disk_problems.h"

#include <gtest/gtest.h>

#include <map>

namespace scree::tests {
namespace {

constexpr double size = 0.03;      // [m], about 500 samples in the pierced domain
constexpr double slack = 1 + 1e-9; // allows for gaps that the sampler leaves unresolved
constexpr std::size_t darts = 100000;

/// A smooth field that is periodic on the unit torus.
std::shared_ptr<const Field> waves(double low, double high, bool angle) {
    SampleGrid grid{64, 64, Vec2(-0.5 + 0.5 / 64), Vec2(1.0 / 64)};
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column) {
            const double wave = std::sin(2 * pi * column / 64) * std::cos(2 * pi * row / 64);
            grid.values.push_back(float(low + (high - low) * (0.5 + 0.5 * wave)));
        }
    grid.torus = true;
    grid.angle = angle;
    return std::make_shared<GridField>(std::move(grid));
}

std::vector<Vec2> positions(const std::vector<DiskSample>& samples) {
    std::vector<Vec2> out;
    for (const DiskSample& s : samples)
        out.push_back(s.position);
    return out;
}

/// The disks in which no sample of the class can be added: the set is maximal if they cover the
/// domain.
std::vector<Disk> disks_against(const DiskSet& set, std::uint32_t disk_class) {
    std::vector<Disk> disks;
    for (const DiskSample& s : set.samples())
        disks.push_back({s.position, set.distance(disk_class, s.disk_class) * slack});
    return disks;
}

std::size_t bare_vertices_of(const DiskSet& set) {
    const PoissonDiskProblem& problem = set.problem();
    std::size_t count = 0;
    for (std::uint32_t c = 0; c < problem.classes.size(); ++c)
        count += bare_vertices(disks_against(set, c), *problem.domain, problem.torus);
    return count;
}

std::size_t far_places_of(const DiskSet& set) {
    return far_places(positions(set.samples()), *set.problem().domain, set.problem().torus,
                      set.distance(0, 0) * slack);
}

bool is_round(const PoissonDiskProblem& problem) {
    return problem.scale == nullptr && std::ranges::all_of(problem.classes, [](const DiskClass& c) {
               return c.length == c.width;
           });
}

/// Checks all required properties of a set.
void expect_maximal(const PoissonDiskProblem& problem, const std::vector<DiskSample>& samples,
                    std::size_t throws = darts) {
    const DiskSet set(problem, samples);
    EXPECT_EQ(set.conflicts(), 0U);
    EXPECT_EQ(set.misplaced(), 0U);
    const Insertion insertion = try_to_insert(set, throws, problem.seed);
    EXPECT_EQ(insertion.fitted, 0U);
    EXPECT_EQ(insertion.reached, 0U)
        << "of " << insertion.climbs << ", up to " << insertion.highest;
    if (problem.relax == 0) { // relaxed sets have few places that almost have room
        EXPECT_GT(insertion.climbs, 20U);
    }
    if (is_round(problem)) {
        EXPECT_EQ(bare_vertices_of(set), 0U);
        if (problem.classes.size() == 1) {
            EXPECT_EQ(far_places_of(set), 0U);
        }
    }
}

std::vector<DiskSample> filled(const PoissonDiskProblem& problem) {
    PoissonDiskSet set = sample_poisson_disks(problem, {});
    // Rotating ellipses may be tangent at a point, which no finite precision resolves.
    EXPECT_LT(set.unresolved, is_round(problem) ? 1U : 30U);
    EXPECT_GE(set.trials, set.samples.size());
    std::vector<DiskSample> all = problem.kept;
    all.insert(all.end(), set.samples.begin(), set.samples.end());
    return all;
}

class PoissonExact : public testing::TestWithParam<std::tuple<Mode, int>> {};

TEST_P(PoissonExact, NoConflictAndNoRoom) {
    const auto& [mode, seed] = GetParam();
    const PoissonDiskProblem problem =
        problem_of(mode, pierced_domain(), size, std::uint64_t(seed));
    const std::vector<DiskSample> samples = filled(problem);
    EXPECT_GT(samples.size(), 100U);
    expect_maximal(problem, samples, seed == 1 ? 1000000 : darts);
}

INSTANTIATE_TEST_SUITE_P(All, PoissonExact,
                         testing::Combine(testing::ValuesIn(all_modes()), testing::Range(1, 21)),
                         [](const auto& test) {
                             return name_of(std::get<0>(test.param)) + "_" +
                                    std::to_string(std::get<1>(test.param));
                         });

class PoissonExactModes : public testing::TestWithParam<Mode> {};

TEST_P(PoissonExactModes, OnATorus) {
    for (const std::uint64_t seed : {1, 2, 3}) {
        PoissonDiskProblem problem = problem_of(GetParam(), square_domain(1), size, seed);
        problem.torus = true;
        if (problem.direction != nullptr && seed > 1) // the whirl is discontinuous at the seam
            problem.direction = waves(0, 180, true);
        expect_maximal(problem, filled(problem));
    }
}

TEST_P(PoissonExactModes, OfRandomTurns) {
    PoissonDiskProblem problem = problem_of(GetParam(), pierced_domain(), size, 3);
    for (DiskClass& c : problem.classes)
        c.turn = {-0.4, 0.9};
    expect_maximal(problem, filled(problem), 300000);
    for (DiskClass& c : problem.classes)
        c.turn = {0, 2 * pi};
    expect_maximal(problem, filled(problem), 300000);
}

TEST_P(PoissonExactModes, WithAFieldOfScales) {
    PoissonDiskProblem problem = problem_of(GetParam(), square_domain(1), size, 4);
    problem.scale = waves(0.6, 1.6, false);
    expect_maximal(problem, filled(problem), 300000);
    problem.torus = true;
    expect_maximal(problem, filled(problem), 300000);
}

TEST_P(PoissonExactModes, RelaxedSetsToo) {
    for (const bool torus : {false, true}) {
        PoissonDiskProblem problem =
            problem_of(GetParam(), torus ? square_domain(1) : pierced_domain(), size, 9);
        problem.torus = torus;
        problem.relax = 5;
        expect_maximal(problem, filled(problem));
    }
}

TEST_P(PoissonExactModes, AHoleIsFilledAgainAndNothingElse) {
    for (const bool torus : {false, true}) {
        PoissonDiskProblem problem = problem_of(GetParam(), square_domain(1), size, 5);
        problem.torus = torus;
        const DiskSet whole(problem, filled(problem));
        // On the torus a hole across its corner.
        const Vec2 middle = torus ? Vec2(0.46, -0.47) : Vec2(-0.1, 0.05);
        const auto distance = [&](Vec2 offset) {
            if (torus)
                offset -= Vec2(std::round(offset.x), std::round(offset.y));
            return offset.length();
        };
        for (const DiskSample& s : whole.samples())
            if (distance(s.position - middle) > 0.12)
                problem.kept.push_back(s);
        problem.seed = 6;
        if (!torus)
            problem.window =
                Box2(middle - Vec2(0.12 + whole.reach()), middle + Vec2(0.12 + whole.reach()));
        const std::vector<DiskSample> all = filled(problem);
        EXPECT_GT(all.size(), problem.kept.size() + 3);
        for (std::size_t i = problem.kept.size(); i < all.size(); ++i)
            EXPECT_LT(distance(all[i].position - middle), 0.12 + whole.reach());
        expect_maximal(problem, all);
    }
}

TEST_P(PoissonExactModes, OnlyTheWindowIsFilled) {
    PoissonDiskProblem problem = problem_of(GetParam(), pierced_domain(), size, 7);
    const Vec2 middle = bounds(*problem.domain).center();
    problem.window = Box2(middle - Vec2(0.2, 0.15), middle + Vec2(0.1, 0.3));
    const DiskSet set(problem, filled(problem));
    EXPECT_EQ(set.conflicts(), 0U);
    EXPECT_EQ(set.misplaced(), 0U);
    for (const DiskSample& s : set.samples())
        EXPECT_TRUE(problem.window->intersects(s.position));
    const Insertion insertion = try_to_insert(set, 300000, 7, problem.window);
    EXPECT_EQ(insertion.fitted, 0U);
    EXPECT_EQ(insertion.reached, 0U);
    EXPECT_GT(insertion.climbs, 20U);
}

INSTANTIATE_TEST_SUITE_P(All, PoissonExactModes, testing::ValuesIn(all_modes()),
                         [](const auto& test) { return name_of(test.param); });

/// Ellipses of one direction are disks in scaled coordinates, where coverage can be tested exactly.
TEST(PoissonExactEllipses, OfOneDirectionCoverExactly) {
    for (const std::uint64_t seed : {1, 2, 3, 4, 5}) {
        PoissonDiskProblem problem = problem_of(Mode::anisotropic, pierced_domain(), size, seed);
        constexpr double angle = 25; // [deg]
        problem.direction = std::make_shared<ConstantField>(angle);
        const DiskClass axes = problem.classes[0];
        const auto to_disks = [&](const Vec2& p) {
            const Vec2 turned = rotate(p, -radians(angle));
            return Vec2(turned.x / axes.length, turned.y / axes.width);
        };
        std::vector<Vec2> points;
        for (const DiskSample& s : filled(problem))
            points.push_back(to_disks(s.position));
        Region domain = *problem.domain;
        for (Ring& ring : domain.rings)
            std::ranges::transform(ring, ring.begin(), to_disks);
        EXPECT_EQ(far_places(points, domain, false, slack), 0U);
        points.erase(points.begin() + 7);
        EXPECT_GT(far_places(points, domain, false, slack), 0U);
    }
}

/// The tests detect a missing sample and a misplaced one.
TEST(PoissonExactItself, DetectsAMissingAndAMovedSample) {
    for (const Mode mode : all_modes())
        for (const bool torus : {false, true}) {
            PoissonDiskProblem problem =
                problem_of(mode, torus ? square_domain(1) : pierced_domain(), size, 8);
            problem.torus = torus;
            const std::vector<DiskSample> samples = filled(problem);
            for (std::size_t removed = 3; removed < samples.size(); removed += 400) {
                std::vector<DiskSample> less = samples;
                less.erase(less.begin() + std::ptrdiff_t(removed));
                const DiskSet set(problem, less);
                const Insertion insertion = try_to_insert(set, 3 * darts, removed);
                EXPECT_GT(insertion.fitted + insertion.reached, 0U) << name_of(mode);
                EXPECT_GE(insertion.highest, 1);
                if (is_round(mode)) {
                    EXPECT_GT(bare_vertices_of(set), 0U) << name_of(mode);
                }
                if (mode == Mode::isotropic) {
                    EXPECT_GT(far_places_of(set), 0U);
                }
                EXPECT_EQ(set.conflicts(), 0U);

                std::vector<DiskSample> moved = samples;
                const Vec2 towards = moved[removed - 1].position - moved[removed].position;
                moved[removed].position += towards * 0.999;
                EXPECT_GT(DiskSet(problem, moved).conflicts(), 0U) << name_of(mode);
            }
        }
}

} // namespace
} // namespace scree::tests
