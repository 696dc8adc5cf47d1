// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "procedurals/solid/lattice/fractal_lattice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace scree {

namespace {

using solid::Fluctuation;
using solid::Triple;

// Two-sided normal bound, for a significance of 1e-6 per comparison.
constexpr double bound = 4.9;

LatticeSettings plain(int levels, double decay, std::uint64_t seed = 5) {
    LatticeSettings settings;
    settings.seed = seed;
    settings.levels = levels;
    settings.detail = 0;
    settings.decay = decay;
    settings.repeats = false;
    settings.sixteen_bit = false;
    return settings;
}

/// Mean and variance, tested against those of n variates N(0, sigma^2).
struct Moments {
    double n = 0, sum = 0, squares = 0;
    void add(double v) {
        n += 1;
        sum += v;
        squares += v * v;
    }
    void expect_normal(double sigma, const char* what) const {
        EXPECT_NEAR(sum / n, 0, bound * sigma / std::sqrt(n)) << what;
        EXPECT_NEAR(squares / n, sigma * sigma, bound * sigma * sigma * std::sqrt(2 / n)) << what;
    }
};

/// The differences of the nodes of a level from the mean of their neighbours, by the number of odd
/// coordinates, as in the paper's three steps.
std::array<Moments, 4> increments(const FractalLattice& lattice, int level) {
    std::array<Moments, 4> found;
    const int cells = 1 << level;
    const int stride = lattice.side() / cells;
    const auto at = [&](int x, int y, int z) {
        return double(lattice.node(x * stride, y * stride, z * stride));
    };
    for (int z = 0; z <= cells; ++z)
        for (int y = 0; y <= cells; ++y)
            for (int x = 0; x <= cells; ++x) {
                double sum = 0;
                const int odd = x % 2 + y % 2 + z % 2;
                if (odd == 0)
                    continue;
                if (x % 2 == 1)
                    sum += at(x - 1, y, z) + at(x + 1, y, z);
                if (y % 2 == 1)
                    sum += at(x, y - 1, z) + at(x, y + 1, z);
                if (z % 2 == 1)
                    sum += at(x, y, z - 1) + at(x, y, z + 1);
                found[std::size_t(odd)].add(at(x, y, z) - sum / (2 * odd));
            }
    return found;
}

Triple somewhere(Random& random, double size = 1) {
    const auto one = [&] { return static_cast<float>(random.uniform(0, size)); };
    const float x = one(), y = one();
    return {x, y, one()};
}

} // namespace

TEST(SolidLattice, IncrementsOfEveryLevelHaveTheMeanAndVarianceOfTheFormula) {
    for (const double decay : {0.0, 0.5, 1.1}) {
        const FractalLattice lattice(plain(6, decay));
        for (int level = 1; level <= 6; ++level) {
            const auto found = increments(lattice, level);
            const double sigma = std::exp(-(level - 1) * decay); // eq. 5
            const char* kinds[] = {"", "edges", "faces", "cubes"};
            for (std::size_t odd = 1; odd <= 3; ++odd)
                found[odd].expect_normal(sigma, kinds[odd]);
        }
    }
}

TEST(SolidLattice, IncrementsAreNormalAndIndependent) {
    const FractalLattice lattice(plain(6, 0));
    const int side = lattice.side();
    std::vector<double> values;
    Moments products[3];
    const auto increment = [&](int x, int y, int z) { // of cubes' centres
        return lattice.node(x, y, z) -
               (lattice.node(x - 1, y, z) + lattice.node(x + 1, y, z) + lattice.node(x, y - 1, z) +
                lattice.node(x, y + 1, z) + lattice.node(x, y, z - 1) + lattice.node(x, y, z + 1)) /
                   6;
    };
    for (int z = 1; z + 2 < side; z += 2)
        for (int y = 1; y + 2 < side; y += 2)
            for (int x = 1; x + 2 < side; x += 2) {
                const double here = double(increment(x, y, z));
                values.push_back(here);
                products[0].add(here * double(increment(x + 2, y, z)));
                products[1].add(here * double(increment(x, y + 2, z)));
                products[2].add(here * double(increment(x, y, z + 2)));
            }
    for (const Moments& moments : products) // of independent N(0, 1): mean 0, variance 1
        EXPECT_NEAR(moments.sum / moments.n, 0, bound / std::sqrt(moments.n));
    // Kolmogorov-Smirnov, significance 1e-6.
    std::sort(values.begin(), values.end());
    double distance = 0;
    const double n = double(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double cdf = 0.5 * std::erfc(-values[i] / std::numbers::sqrt2);
        distance = std::max({distance, cdf - double(i) / n, double(i + 1) / n - cdf});
    }
    EXPECT_LT(distance * std::sqrt(n), std::sqrt(-0.5 * std::log(0.5e-6)));
}

TEST(SolidLattice, VariatesAreNormalInTheTailsToo) {
    // The inverse distribution function against the C library's error function.
    for (std::uint32_t bits = 0; bits < 0xffffff00U; bits += 0x10100) {
        const double g = double(solid::normal_variate(bits));
        const double u = (double(bits >> 8) + 0.5) * 0x1p-24;
        const double back = 0.5 * std::erfc(-g / std::numbers::sqrt2);
        EXPECT_NEAR(back / u, 1, 1e-5) << bits;
    }
    EXPECT_NEAR(double(solid::normal_variate(0xffffffffU)), 5.4190, 1e-3); // Phi^-1(1 - 2^-25)
    EXPECT_EQ(solid::normal_variate(0), -solid::normal_variate(0xffffffffU));
}

TEST(SolidLattice, IsTheSumOfItsLevels) {
    const FractalLattice lattice(plain(6, 0.6));
    Random random(3, Purpose::test);
    for (int i = 0; i < 2000; ++i) {
        const Triple p = somewhere(random);
        Fluctuation sum = solid::corner_field(&lattice.header(), p);
        for (int level = 1; level <= 6; ++level)
            solid::add_field(&sum, solid::level_field(&lattice.header(), level, p),
                             lattice.header().amplitude[level]);
        const Fluctuation stored = lattice.at(p);
        EXPECT_NEAR(stored.value, sum.value, 2e-5);
        EXPECT_NEAR(stored.gradient.x, sum.gradient.x, 2e-3);
        EXPECT_NEAR(stored.gradient.y, sum.gradient.y, 2e-3);
        EXPECT_NEAR(stored.gradient.z, sum.gradient.z, 2e-3);
    }
}

TEST(SolidLattice, StoredAndOnDemandLevelsAgreeEverywhere) {
    // Few stored levels and many on demand, in the first cube and beyond it, are one field.
    for (const bool repeats : {true, false}) {
        LatticeSettings few = plain(2, 0.7), many = plain(6, 0.7);
        few.repeats = many.repeats = repeats;
        few.detail = 6;
        many.detail = 2;
        const FractalLattice a(few), b(many);
        Random random(4, Purpose::test);
        for (int i = 0; i < 3000; ++i) {
            Triple p = somewhere(random, 4);
            p.x -= 2;
            p.z -= 1;
            for (const float width : {0.0F, 0.01F, 0.11F, 0.4F, 3.0F}) {
                const Fluctuation one = a.at(p, width), other = b.at(p, width);
                EXPECT_NEAR(one.value, other.value, 3e-5) << width;
                EXPECT_NEAR(one.variance, other.variance, 1e-5) << width;
            }
        }
    }
}

TEST(SolidLattice, TheTileIsTheSumOfItsLevels) {
    for (const int stored : {0, 6, 7, 8})
        for (const bool repeats : {true, false}) {
            LatticeSettings settings = plain(stored, 0.4);
            settings.detail = 14 - stored;
            settings.repeats = repeats;
            const FractalLattice lattice(settings);
            Random random(9, Purpose::test);
            for (int i = 0; i < 500; ++i) {
                Triple p = somewhere(random, 2);
                p = solid::into_domain(&lattice.header(), p);
                for (const float width : {0.0F, 0.0007F, 0.004F, 0.011F}) {
                    const float resolved = solid::resolved_level(&lattice.header(), width);
                    const int whole = static_cast<int>(resolved);
                    Fluctuation sum = solid::corner_field(&lattice.header(), p);
                    solid::add_levels_plainly(&lattice.header(), 1, whole,
                                              resolved - static_cast<float>(whole), p, &sum);
                    const Fluctuation found = lattice.at(p, width);
                    EXPECT_NEAR(found.value, sum.value, 5e-5) << stored << " " << width;
                    const float steep = 1e-4F * (1 + std::abs(sum.gradient.x));
                    EXPECT_NEAR(found.gradient.x, sum.gradient.x, 100 * steep);
                }
            }
        }
}

TEST(SolidLattice, MoreLevelsRefineFewer) {
    const FractalLattice coarse(plain(4, 0.5)), fine(plain(6, 0.5));
    for (int z = 0; z <= 16; z += 3)
        for (int y = 0; y <= 16; ++y)
            for (int x = 0; x <= 16; ++x)
                EXPECT_EQ(coarse.node(x, y, z), fine.node(4 * x, 4 * y, 4 * z));
}

TEST(SolidLattice, RepeatsExactly) {
    LatticeSettings settings = plain(5, 0.5);
    settings.repeats = true;
    settings.detail = 3;
    const FractalLattice lattice(settings);
    for (int b = 0; b <= 32; ++b)
        for (int a = 0; a <= 32; ++a) {
            EXPECT_EQ(lattice.node(0, a, b), lattice.node(32, a, b));
            EXPECT_EQ(lattice.node(a, 0, b), lattice.node(a, 32, b));
            EXPECT_EQ(lattice.node(a, b, 0), lattice.node(a, b, 32));
        }
    Random random(5, Purpose::test);
    for (int i = 0; i < 1000; ++i) {
        const Triple p = {float(random.below(4096)) / 4096, float(random.below(4096)) / 4096,
                          float(random.below(4096)) / 4096};
        const Fluctuation here = lattice.at(p), there = lattice.at({p.x + 3, p.y - 2, p.z + 1});
        EXPECT_EQ(here.value, there.value);
        EXPECT_EQ(here.gradient.y, there.gradient.y);
    }
}

TEST(SolidLattice, IsContinuousAcrossCellsAndCubes) {
    // A step of 2^-20 across a face changes the value by at most what the slopes on both sides
    // allow: at faces of cells of every level, of the first cube, and of cubes far away.
    for (const bool repeats : {true, false}) {
        LatticeSettings settings = plain(5, 0.7);
        settings.repeats = repeats;
        settings.detail = 2;
        settings.sixteen_bit = true;
        const FractalLattice lattice(settings);
        Random random(6, Purpose::test);
        constexpr float h = 0x1p-20F;
        for (int i = 0; i < 4000; ++i) {
            Triple p = somewhere(random);
            const int level = static_cast<int>(random.below(8));
            const float face = static_cast<float>(random.below((1U << level) + 1)) /
                               static_cast<float>(1 << level);
            float* axis[] = {&p.x, &p.y, &p.z};
            float& across = *axis[random.below(3)];
            across = face - h;
            const Fluctuation before = lattice.at(p);
            across = face + h;
            const Fluctuation after = lattice.at(p);
            const auto steepest = [](const Fluctuation& f) {
                return std::max(
                    {std::abs(f.gradient.x), std::abs(f.gradient.y), std::abs(f.gradient.z)});
            };
            // Outside the first cube nothing is stored, so nothing is rounded to 16 bits.
            const float rounding = repeats ? 2e-5F : 2e-5F + lattice.header().step;
            EXPECT_LE(std::abs(after.value - before.value),
                      h * (steepest(before) + steepest(after)) + rounding)
                << "level " << level << " face " << face;
        }
    }
}

TEST(SolidLattice, GradientIsTheSlope) {
    const FractalLattice lattice(plain(5, 0.5));
    Random random(7, Purpose::test);
    for (int i = 0; i < 500; ++i) {
        Triple p = somewhere(random);
        const auto inside = [](float v) { // of a cell
            return (std::floor(v * 32) + 0.1F + 0.8F * (v * 32 - std::floor(v * 32))) / 32;
        };
        p = {inside(p.x), inside(p.y), inside(p.z)};
        const Fluctuation f = lattice.at(p);
        constexpr float h = 0x1p-9F * 0.5F;
        const auto slope = [&](Triple d) {
            return (lattice.at(solid::plus(p, d)).value - lattice.at(solid::minus(p, d)).value) /
                   (2 * h);
        };
        EXPECT_NEAR(f.gradient.x, slope({h, 0, 0}), 5e-3);
        EXPECT_NEAR(f.gradient.y, slope({0, h, 0}), 5e-3);
        EXPECT_NEAR(f.gradient.z, slope({0, 0, h}), 5e-3);
    }
}

TEST(SolidLattice, SixteenBitErrorIsAtMostHalfAStep) {
    LatticeSettings settings = plain(5, 0.5);
    const FractalLattice exact(settings);
    settings.sixteen_bit = true;
    const FractalLattice rounded(settings);
    EXPECT_TRUE(rounded.nodes32().empty());
    for (int z = 0; z <= 32; ++z)
        for (int y = 0; y <= 32; ++y)
            for (int x = 0; x <= 32; ++x)
                ASSERT_NEAR(exact.node(x, y, z), rounded.node(x, y, z),
                            0.501F * rounded.header().step);
    EXPECT_LT(rounded.header().step, 4e-4F);
}

TEST(SolidLattice, UnresolvedLevelsHaveTheStatedVariance) {
    // The mean square of all levels minus the resolved ones, over many lattices and places. Only at
    // widths that resolve whole levels (sqrt 2 times powers of 2): in between, one level is partly
    // resolved, and the variance within the filter is not that of the part left out.
    for (const float width : {0.0441942F, 0.1767767F, 0.3535534F, 1.4142136F}) {
        double squares = 0, said = 0;
        const int lattices = 40, places = 400;
        for (int l = 0; l < lattices; ++l) {
            LatticeSettings settings = plain(5, 0.45, 100 + std::uint64_t(l));
            settings.detail = 2;
            const FractalLattice lattice(settings);
            Random random(8, Purpose::test, std::uint64_t(l));
            for (int i = 0; i < places; ++i) {
                const Triple p = somewhere(random);
                const Fluctuation coarse = lattice.at(p, width);
                const double off = double(lattice.at(p).value - coarse.value);
                squares += off * off;
                said += double(coarse.variance);
            }
        }
        EXPECT_NEAR(squares / said, 1, 0.05) << width; // coarse levels have few nodes per lattice
    }
}

} // namespace scree
