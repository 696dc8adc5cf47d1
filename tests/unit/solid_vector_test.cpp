// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "procedurals/solid/lattice/fractal_lattice.h"
#include "procedurals/solid/lattice/vector_path.h"
#include "procedurals/solid/marble/stripes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>

namespace scree {

namespace {

using solid::Fluctuation;

bool same_bits(const Fluctuation& a, const Fluctuation& b) {
    using Bits = std::array<std::uint32_t, sizeof(Fluctuation) / 4>;
    return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}

/// This machine has the scalar reference and at least one vector path.
TEST(SolidVector, TheReferenceIsTheLastPath) {
    ASSERT_GE(vector_paths().size(), 1U);
    EXPECT_EQ(vector_paths().back(), "scalar");
    EXPECT_FALSE(scalar_path_in_use());
    const UseVectorPath path("scalar");
    EXPECT_TRUE(scalar_path_in_use());
}

TEST(SolidVector, LatticesAreTheSameBitForBitOnAllPaths) {
    for (const int levels : {0, 1, 2, 3, 5, 6})
        for (const bool repeats : {true, false})
            for (const bool sixteen_bit : {true, false})
                for (const double decay : {0.0, 0.8, 30.0}) {
                    LatticeSettings settings;
                    settings.levels = levels;
                    settings.repeats = repeats;
                    settings.sixteen_bit = sixteen_bit;
                    settings.decay = decay;
                    const auto make = [&](const std::string& name) {
                        const UseVectorPath path(name);
                        return FractalLattice(settings);
                    };
                    const FractalLattice reference = make("scalar");
                    for (const std::string& name : vector_paths()) {
                        const FractalLattice found = make(name);
                        EXPECT_EQ(found.header().step, reference.header().step) << name;
                        EXPECT_TRUE(std::ranges::equal(found.nodes16(), reference.nodes16()))
                            << name << " levels " << levels;
                        const auto bits = [](float v) { return std::bit_cast<std::uint32_t>(v); };
                        EXPECT_TRUE(std::ranges::equal(found.nodes32(), reference.nodes32(), {},
                                                       bits, bits))
                            << name << " levels " << levels << " decay " << decay;
                    }
                }
}

TEST(SolidVector, CellsAreTheSameBitForBit) {
    constexpr int side = 9;
    std::vector<short> nodes16(side * side * side);
    std::vector<float> nodes32(nodes16.size());
    Random random(12, Purpose::test);
    for (std::size_t i = 0; i < nodes16.size(); ++i) {
        nodes16[i] = static_cast<short>(int(random.below(65535)) - 32767);
        nodes32[i] = float(random.uniform(-5, 5));
    }
    for (int i = 0; i < 2000; ++i) {
        const int stride = 1 << random.below(3), most = (side - 1) / stride;
        int first = 0;
        for (int k = 0; k < 3; ++k)
            first = first * side + stride * int(random.below(std::uint32_t(most)));
        const solid::Triple in{random.uniform_float(), random.uniform_float(),
                               random.uniform_float()};
        for (const float step : {1.3e-4F, 0.0F}) {
            const solid::Fluctuation one = solid::cell_field(nodes16.data(), nodes32.data(), first,
                                                             stride, side, step, in, 8),
                                     other = solid::cell_field_plainly(nodes16.data(),
                                                                       nodes32.data(), first,
                                                                       stride, side, step, in, 8);
            EXPECT_TRUE(same_bits(one, other)) << i << " " << step;
        }
    }
}

TEST(SolidVector, LevelsOnDemandAreTheSameBitForBitOnAllPaths) {
    // Also far from the first cube, and where the filter resolves a level partly.
    for (const bool repeats : {true, false}) {
        LatticeSettings settings;
        settings.levels = 3;
        settings.detail = 10;
        settings.repeats = repeats;
        const FractalLattice lattice(settings);
        for (const std::string& name : vector_paths()) {
            Random random(1, Purpose::test);
            for (int i = 0; i < 2000; ++i) {
                const auto one = [&] { return static_cast<float>(random.uniform(-3, 3)); };
                const float x = one(), y = one(), z = one();
                const float width = i % 3 == 0 ? 0 : std::exp2(-random.uniform_float() * 14);
                const auto answer = [&](const std::string& path_name) {
                    const UseVectorPath path(path_name);
                    return lattice.at({x, y, z}, width);
                };
                const Fluctuation expected = answer("scalar"), found = answer(name);
                ASSERT_EQ(found.value, expected.value) << name << " width " << width;
                ASSERT_EQ(found.gradient.x, expected.gradient.x) << name;
                ASSERT_EQ(found.gradient.y, expected.gradient.y) << name;
                ASSERT_EQ(found.gradient.z, expected.gradient.z) << name;
                ASSERT_EQ(found.variance, expected.variance) << name;
            }
        }
    }
}

/// Places in and around a box, one of them at its corner.
struct Places {
    std::vector<float> x{0}, y{0}, z{0};

    Places(float low, float high, std::size_t count) {
        Random random(2, Purpose::test);
        const auto one = [&] { return low + (high - low) * random.uniform_float(); };
        while (x.size() < count) {
            x.push_back(one());
            y.push_back(one());
            z.push_back(one());
        }
    }
};

std::vector<float> values_on(const std::string& name, std::size_t count, const auto& evaluate) {
    const UseVectorPath path(name);
    std::vector<float> found(count);
    evaluate(std::span<float>(found));
    return found;
}

/// Checks that all vector paths give the same bits; returns these and the results of the scalar
/// path.
std::pair<std::vector<float>, std::vector<float>> compared(std::size_t count,
                                                           const auto& evaluate) {
    const std::vector<float> found = values_on(vector_paths().front(), count, evaluate);
    for (const std::string& name : vector_paths())
        if (name != "scalar") {
            EXPECT_EQ(values_on(name, count, evaluate), found) << name;
        }
    return {found, values_on("scalar", count, evaluate)};
}

TEST(SolidVector, FluctuationsOfManyPointsAreThoseOfTheLattice) {
    for (const bool repeats : {true, false})
        for (const bool sixteen_bit : {true, false})
            for (const int level : {0, 2, 5}) {
                LatticeSettings settings;
                settings.levels = 5;
                settings.decay = 0.2; // neighbours differ a lot
                settings.repeats = repeats;
                settings.sixteen_bit = sixteen_bit;
                const FractalLattice lattice(settings);
                const LatticeQuads quads(lattice, level);
                const Places places(-2, 3, 1003);
                const auto [found, expected] = compared(places.x.size(), [&](std::span<float> out) {
                    quads.fluctuations(places.x, places.y, places.z, out);
                });
                for (std::size_t i = 0; i < found.size(); ++i)
                    ASSERT_NEAR(found[i], expected[i], quads.error()) << i << " level " << level;
                EXPECT_LT(quads.error(), 3e-4F);
            }
}

solid::Vein vein(float centre, float half_width, float rate) {
    solid::Vein found{};
    found.centre = centre;
    found.half_width = half_width;
    found.rate = rate;
    return found;
}

/// Eq. 8 in double precision.
double vein_sum(const std::vector<solid::Vein>& veins, double period, double z) {
    double sum = 0;
    for (const solid::Vein& vein : veins) {
        double away = z - double(vein.centre);
        if (period > 0)
            away -= period * std::round(away / period);
        sum +=
            std::exp(-double(vein.rate) * std::max(0.0, std::abs(away) - double(vein.half_width)));
    }
    return std::min(sum, 1.0);
}

TEST(SolidVector, VeinsOfManyPointsAreTheFormula) {
    const std::vector<std::vector<solid::Vein>> sets = {
        {},
        {vein(0.5F, 0.05F, 30)},
        {vein(0.08F, 0.01F, 43), vein(0.22F, 0.01F, 50), vein(0.41F, 0.02F, 52),
         vein(0.55F, 0.01F, 60), vein(0.73F, 0.005F, 62), vein(0.91F, 0.01F, 67)},
        {vein(0.3F, 0, 80), vein(0.3F, 0.1F, 20), vein(0.34F, 0.01F, 20)}, // more than 1 together
        {vein(0.6F, 0.001F, 3000), vein(0.2F, 0.2F, 2)},
        {vein(0.25F, 1e-5F, 1e7F), vein(0.75F, 0.1F, 1e30F)}}; // bins are too wide for these
    std::vector<float> z;
    for (int i = -5000; i < 40000; ++i)
        z.push_back(i < 0 ? 0.017F * static_cast<float>(i) : -1.5F + 1e-4F * static_cast<float>(i));
    for (const auto& veins : sets)
        for (const float period : {0.0F, 1.0F, 1.3F}) {
            const VeinTable table(veins, period);
            const auto [found, scalar] =
                compared(z.size(), [&](std::span<float> out) { table.values(z, z, 0, out); });
            for (std::size_t i = 0; i < z.size(); ++i) {
                // Against the formula at any place within two ulp of z.
                const double reach = std::max(std::abs(double(z[i])), 0.5) * 0x1p-22;
                double low = 1, high = 0;
                for (int step = -4; step <= 4; ++step) {
                    const double value =
                        vein_sum(veins, double(period), double(z[i]) + reach * step / 4);
                    low = std::min(low, value);
                    high = std::max(high, value);
                }
                ASSERT_GE(double(found[i]), low - 3e-6) << z[i] << " period " << period;
                ASSERT_LE(double(found[i]), high + 3e-6) << z[i] << " period " << period;
                ASSERT_GE(double(scalar[i]), low - 3e-6) << z[i] << " period " << period;
                ASSERT_LE(double(scalar[i]), high + 3e-6) << z[i] << " period " << period;
            }
        }
}

TEST(SolidVector, MarbleAndWoodAreDisplacedByTheFluctuations) {
    LatticeSettings settings;
    settings.levels = 5;
    const FractalLattice lattice(settings);
    const LatticeQuads quads(lattice);
    const Places places(0, 1, 2500);
    const std::size_t count = places.x.size();
    const auto [d, unused] = compared(count, [&](std::span<float> out) {
        quads.fluctuations(places.x, places.y, places.z, out);
    });

    const std::vector<solid::Vein> veins{vein(0.3F, 0.02F, 20), vein(0.8F, 0.01F, 40)};
    const VeinTable table(veins, 1);
    const auto [marble, plain_marble] = compared(count, [&](std::span<float> out) {
        marble_values(quads, table, 0.25F, places.x, places.y, places.z, out);
    });
    const PlainWood wood{0.4F, 0.6F, 12, 0.025F};
    const auto [rings, plain_rings] = compared(count, [&](std::span<float> out) {
        wood_values(quads, wood, places.x, places.y, places.z, out);
    });
    for (std::size_t i = 0; i < count; ++i) {
        const double z = double(places.z[i]) - 0.25 * double(d[i]);
        ASSERT_NEAR(double(marble[i]), vein_sum(veins, 1, z), 1e-5);
        ASSERT_NEAR(marble[i], plain_marble[i], 1e-5F + 40 * 0.25F * quads.error());
        const double r = std::hypot(double(places.x[i]) - 0.4, double(places.y[i]) - 0.6);
        const double turns = 12 * (r - 0.025 * double(d[i]));
        ASSERT_NEAR(double(rings[i]), std::sin(2 * std::numbers::pi * turns), 1e-5);
        ASSERT_NEAR(rings[i], plain_rings[i], 1e-5F + 6.3F * 12 * 0.025F * quads.error());
    }
}

} // namespace

} // namespace scree
