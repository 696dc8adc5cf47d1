// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/parallel.h"
#include "tests/support/leather.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

namespace scree {
namespace {

using tests::leather;
using tests::preset;
using tests::request;

/// Two-sample test of the seam. For every border between two columns the Kolmogorov-Smirnov
/// distance between what is seen across it, row by row, and what is seen across all borders
/// together. If the seam is like the others its distance is as likely as theirs to have any rank:
/// the share of borders with a distance as large is its significance. Rows depend on each other,
/// and do so alike for every border, so the rank stays fair.
double seam_significance(const Image& map, bool of_slopes) {
    const int n = map.width;
    const auto at = [&](int x, int y) { return *map.at((x % n + n) % n, y); };
    const auto seen = [&](int x, int y) { // across the border on the left of column x
        const float jump = at(x, y) - at(x - 1, y);
        return of_slopes ? (at(x + 1, y) - at(x, y)) - (at(x - 1, y) - at(x - 2, y)) : jump;
    };
    std::vector<float> all;
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < n; ++x)
            all.push_back(seen(x, y));
    std::sort(all.begin(), all.end());
    std::vector<double> distances;
    for (int x = 0; x < n; ++x) {
        std::vector<float> column;
        for (int y = 0; y < map.height; ++y)
            column.push_back(seen(x, y));
        std::sort(column.begin(), column.end());
        double distance = 0;
        for (std::size_t i = 0; i < column.size(); ++i) {
            const double share =
                double(std::lower_bound(all.begin(), all.end(), column[i]) - all.begin()) /
                double(all.size());
            distance = std::max({distance, std::abs(share - double(i) / double(column.size())),
                                 std::abs(share - double(i + 1) / double(column.size()))});
        }
        distances.push_back(distance);
    }
    const auto as_far = std::count_if(distances.begin(), distances.end(),
                                      [&](double d) { return d >= distances.front(); });
    return double(as_far) / double(n);
}

Image turned(const Image& map) {
    Image out(map.height, map.width, map.channels);
    for (int y = 0; y < map.height; ++y)
        for (int x = 0; x < map.width; ++x)
            *out.at(y, x) = *map.at(x, y);
    return out;
}

// The change of slope at a seam shows at three borders of 384 or more, so that less than 1 in 128
// could not be seen.
constexpr double significance = 0.01;

class Preset : public testing::TestWithParam<std::string> {};

TEST_P(Preset, HasNoSeam) {
    const HeightField field = leather_relief(request(preset(GetParam()), 512), {}).as_height();
    for (const bool of_slopes : {false, true}) {
        EXPECT_GT(seam_significance(field.image, of_slopes), significance);
        EXPECT_GT(seam_significance(turned(field.image), of_slopes), significance);
    }
    // The test sees a seam where there is one: the left three quarters do not tile.
    Image part(384, 512, {"Y"});
    for (int y = 0; y < 512; ++y)
        for (int x = 0; x < 384; ++x)
            *part.at(x, y) = *field.image.at(x, y);
    EXPECT_LT(seam_significance(part, false), significance);
    EXPECT_LT(seam_significance(part, true), significance);
}

TEST_P(Preset, IsFiniteAndAsHighAsItSays) {
    const LeatherSettings& s = preset(GetParam());
    ReliefFacts facts;
    const HeightField field = leather_relief(request(s, 256), {}, &facts);
    for (const float v : field.image.pixels)
        ASSERT_TRUE(std::isfinite(v));
    EXPECT_GT(facts.cells, 30U);
    EXPECT_GT(facts.fill, 0.55);
    EXPECT_GT(facts.highest, 0.6 * s.depth);
    EXPECT_LT(facts.highest, (1 + s.height_variation) * (1 + s.tilt) * s.depth +
                                 3 * (s.undulation + s.roughness) + 0.2 * s.pore_depth);
    EXPECT_LT(facts.lowest, 0);
    EXPECT_GT(facts.lowest, -(s.groove_depth + s.minor_depth + s.wrinkle_depth + s.pore_depth +
                              3 * (s.undulation + s.roughness)));
}

TEST_P(Preset, IsTheSameOnAnyNumberOfThreads) {
    Aggregate made[2];
    for (const int threads : {1, 2}) {
        const ThreadLimit limit(threads);
        made[threads - 1] = leather_plugin().make(leather(GetParam()))({});
    }
    const auto same_bytes = [](const auto& a, const auto& b) {
        return a.size() == b.size() &&
               std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0;
    };
    EXPECT_TRUE(same_bytes(made[0].height->image.pixels, made[1].height->image.pixels));
    const Mesh &a = *made[0].prototypes[0].mesh(), &b = *made[1].prototypes[0].mesh();
    EXPECT_TRUE(same_bytes(a.positions, b.positions));
    EXPECT_TRUE(same_bytes(a.normals, b.normals));
    EXPECT_TRUE(same_bytes(a.triangles, b.triangles));
}

INSTANTIATE_TEST_SUITE_P(All, Preset,
                         testing::Values("fine_calf", "coarse_grain", "reptile", "pebbled"),
                         [](const auto& tested) { return tested.param; });

TEST(Leather, SeedsDifferAndParametersOverrideThePreset) {
    const LeatherSettings& s = preset("pebbled");
    ReliefRequest one = request(s, 64), other = one;
    other.seed = 6;
    EXPECT_NE(leather_relief(one, {}).image.pixels, leather_relief(other, {}).image.pixels);
    Params params = leather("pebbled");
    EXPECT_EQ(settings_from(params).depth, s.depth);
    params.set("depth", 1e-4);
    params.set("cell_range", Range{0.5, 0.7});
    EXPECT_EQ(settings_from(params).depth, 1e-4);
    EXPECT_EQ(settings_from(params).cell_range.high, 0.7);
    EXPECT_EQ(settings_from(params).cell, s.cell);
}

TEST(Leather, CristaeRiseAndSulciSinkAtTheSamePlaces) {
    ReliefRequest r = request(preset("coarse_grain"), 256);
    r.settings.minor_depth = 0;
    r.settings.groove_variation = 0;
    r.parts = ReliefParts::cristae;
    const HeightField cristae = leather_relief(r, {});
    r.parts = ReliefParts::sulci;
    const HeightField sulci = leather_relief(r, {});
    double product = 0, a2 = 0, b2 = 0, a1 = 0, b1 = 0;
    const auto count = double(cristae.image.pixels.size());
    for (std::size_t i = 0; i < cristae.image.pixels.size(); ++i) {
        const double a = cristae.image.pixels[i], b = sulci.image.pixels[i];
        EXPECT_GE(a, 0);
        EXPECT_LE(b, 0);
        product += a * b;
        a1 += a;
        b1 += b;
        a2 += a * a;
        b2 += b * b;
    }
    const double covariance = product / count - a1 / count * (b1 / count);
    const double correlation = covariance / std::sqrt((a2 / count - a1 * a1 / count / count) *
                                                      (b2 / count - b1 * b1 / count / count));
    EXPECT_GT(correlation, 0.5) << "low where the grooves are";
}

} // namespace
} // namespace scree
