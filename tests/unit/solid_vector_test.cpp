// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "procedurals/solid/fractal_lattice.h"
#include "procedurals/solid/vector_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace scree {

namespace {

using solid::Fluctuation;

/// Whether a test finds the scalar reference and at least one vector path on this machine.
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

TEST(SolidVector, LevelsOnDemandAreTheSameBitForBitOnAllPaths) {
    // Also far from the first cube, and where the filter takes a share of a level.
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

} // namespace

} // namespace scree
