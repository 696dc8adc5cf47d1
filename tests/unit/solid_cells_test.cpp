// SPDX-License-Identifier: GPL-3.0-or-later
// The search for seeds against brute force, and the measured constants.
#include "core/random.h"
#include "procedurals/solid/cells/beds_as_cpp.h"
#include "procedurals/solid/cells/creases_as_cpp.h"
#include "procedurals/solid/cells/spots_as_cpp.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace scree {

namespace {

using solid::CellView;
using solid::Seeds;

CellView view_at(float x, float y, float z) {
    CellView view{};
    view.place = {x, y, z};
    view.key = 4711;
    return view;
}

/// All seeds in 7 x 7 x 7 cubes, each found separately.
std::vector<solid::Seed> all_seeds(const CellView& view, float jitter) {
    std::vector<solid::Seed> found;
    for (int z = -3; z <= 3; ++z)
        for (int y = -3; y <= 3; ++y)
            for (int x = -3; x <= 3; ++x) {
                // A search from the middle of a cube finds its seed: the one that lies in the cube.
                CellView there = view;
                const float cx = std::floor(view.place.x) + float(x) + 0.5F,
                            cy = std::floor(view.place.y) + float(y) + 0.5F,
                            cz = std::floor(view.place.z) + float(z) + 0.5F;
                there.place = {cx, cy, cz};
                Seeds seeds;
                solid::gather_seeds(there, jitter, 0.8661F, 10, 0, &seeds);
                for (int i = 0; i < seeds.count; ++i) {
                    solid::Seed seed = seeds.seed[i];
                    if (std::max({std::abs(seed.away.x), std::abs(seed.away.y),
                                  std::abs(seed.away.z)}) > 0.5F)
                        continue;
                    seed.away = solid::plus(seed.away, solid::minus(there.place, view.place));
                    found.push_back(seed);
                }
            }
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) {
        return solid::far_square(a) < solid::far_square(b);
    });
    return found;
}

void expect_search_is_exact(float x, float y, float z, float jitter) {
    const CellView view = view_at(x, y, z);
    const std::vector<solid::Seed> all = all_seeds(view, jitter);
    ASSERT_EQ(all.size(), 343U);
    const float f1 = std::sqrt(solid::far_square(all[0])),
                f2 = std::sqrt(solid::far_square(all[1]));
    // All seeds within the requested margin are found.
    Seeds seeds;
    solid::gather_seeds(view, jitter, CELLS_REACH, 0.5F * (f2 - f1) + 1e-4F, 0, &seeds);
    ASSERT_GE(seeds.count, 2);
    EXPECT_NEAR(solid::length_of(seeds.seed[0].away), f1, 1e-5F);
    float second = 10;
    for (int i = 1; i < seeds.count; ++i)
        second = std::min(second, solid::length_of(seeds.seed[i].away));
    EXPECT_NEAR(second, f2, 1e-5F);
    // The distance to the nearest border.
    float border = 10;
    for (std::size_t i = 1; i < all.size(); ++i) {
        const float span = solid::length_of(solid::minus(all[i].away, all[0].away));
        border =
            std::min(border, 0.5F * (solid::far_square(all[i]) - solid::far_square(all[0])) / span);
    }
    for (const float margin : {0.0F, 0.1F, 0.3F}) {
        solid::gather_seeds(view, jitter, CELLS_REACH, margin, 0, &seeds);
        EXPECT_NEAR(solid::length_of(seeds.seed[0].away), f1, 1e-5F);
        solid::Triple inwards;
        const float found = solid::border_distance(&seeds, margin, &inwards);
        EXPECT_NEAR(std::min(found, margin), std::min(border, margin), 1e-5F);
    }
}

} // namespace

TEST(SolidCells, SearchIsExact) {
    Random random(2, Purpose::test);
    for (const float jitter : {1.0F, 0.6F}) {
        for (int i = 0; i < 400; ++i)
            expect_search_is_exact(float(random.uniform(-50, 50)), float(random.uniform(-50, 50)),
                                   float(random.uniform(-50, 50)), jitter);
        for (int x = 0; x < 5; ++x) // on the grid's faces, edges and corners
            for (int y = 0; y < 4; ++y)
                for (int z = -2; z < 3; ++z)
                    expect_search_is_exact(float(x), float(y) + ((x + y) % 2 == 0 ? 0.5F : 0.0F),
                                           float(z), jitter);
    }
}

TEST(SolidCells, ListsAreLongEnough) {
    Random random(3, Purpose::test);
    int most = 0;
    Seeds seeds;
    for (int i = 0; i < 100000; ++i) {
        solid::gather_seeds(view_at(float(random.uniform(-500, 500)),
                                    float(random.uniform(-500, 500)),
                                    float(random.uniform(-500, 500))),
                            1, CELLS_REACH, 10, 0, &seeds);
        most = std::max(most, seeds.count);
    }
    EXPECT_LT(most, CELLS_MAX_SEEDS);
}

TEST(SolidCells, MeansOfCreasesAreAsMeasured) {
    Random random(4, Purpose::test);
    for (const float softness : {0.01F, 0.05F, 0.1F, 0.2F}) {
        double mean = 0, slope = 0;
        constexpr int places = 20000;
        for (int i = 0; i < places; ++i) {
            Seeds seeds;
            const solid::Crease crease = solid::crease_at(view_at(float(random.uniform(0, 500)),
                                                                  float(random.uniform(0, 500)),
                                                                  float(random.uniform(0, 500))),
                                                          1, softness, &seeds);
            mean += double(crease.value) / places;
            slope += double(solid::dot3(crease.slope, crease.slope)) / places;
            EXPECT_EQ(crease.lost, 0);
        }
        EXPECT_NEAR(double(solid::crease_mean(softness)) / mean, 1, 0.05) << softness;
        EXPECT_NEAR(double(solid::crease_mean_slope(softness)) / slope, 1, 0.1) << softness;
    }
}

} // namespace scree
