// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "generators/leather/groove_network.h"
#include "generators/leather/membrane.h"
#include "generators/leather/relief.h"
#include "generators/leather/tile_noise.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace scree {
namespace {

CellLayout some_cells(double size = 1, std::uint64_t seed = 3) {
    return place_cells(size, {{0.11 * size, {0.4, 1.4}, 1.5, 0.3, 1.0, 0.9}}, seed, 0, {});
}

/// The outline of a cell where it lies, moved by whole tiles.
Ring placed(const CellLayout& layout, const Cell& cell, const Vec2& tiles) {
    Ring ring;
    for (const Vec2& p : layout.shapes[cell.shape].outline().rings.front())
        ring.push_back(cell.pose.apply(p) + tiles * layout.size);
    return ring;
}

bool cross_each_other(const Ring& a, const Ring& b) {
    const auto turn = [](const Vec2& p, const Vec2& q, const Vec2& r) {
        const auto x = static_cast<long double>(q.x) - p.x, y = static_cast<long double>(q.y) - p.y;
        const long double value =
            x * (static_cast<long double>(r.y) - p.y) - y * (static_cast<long double>(r.x) - p.x);
        return value > 0 ? 1 : value < 0 ? -1 : 0;
    };
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j) {
            const Vec2 &p = a[i], &q = a[(i + 1) % a.size()];
            const Vec2 &r = b[j], &s = b[(j + 1) % b.size()];
            if (turn(p, q, r) != turn(p, q, s) && turn(r, s, p) != turn(r, s, q))
                return true;
        }
    return false;
}

bool holds(const Ring& ring, const Vec2& point) {
    Region region;
    region.rings = {ring};
    return contains(region, point);
}

TEST(CellLayout, RegionsDoNotOverlapEvenAcrossTheBorder) {
    const CellLayout layout = some_cells();
    ASSERT_GT(layout.cells.size(), 60U);
    std::size_t neighbours = 0, across = 0;
    for (std::size_t i = 0; i < layout.cells.size(); ++i)
        for (std::size_t j = i; j < layout.cells.size(); ++j)
            for (int y = -1; y <= 1; ++y)
                for (int x = -1; x <= 1; ++x) {
                    if (i == j && x == 0 && y == 0)
                        continue;
                    const Ring a = placed(layout, layout.cells[i], {0.0, 0.0});
                    const Ring b = placed(layout, layout.cells[j], Vec2(x, y));
                    if ((a.front() - b.front()).length() > 0.4)
                        continue;
                    ++neighbours;
                    across += x != 0 || y != 0 ? 1 : 0;
                    ASSERT_FALSE(cross_each_other(a, b)) << i << " " << j;
                    ASSERT_FALSE(holds(a, b.front())) << i << " " << j;
                    ASSERT_FALSE(holds(b, a.front())) << i << " " << j;
                }
    EXPECT_GT(neighbours, 1000U);
    EXPECT_GT(across, 100U) << "the border was looked at";
    EXPECT_GT(layout.fill(), 0.6);
}

TEST(CellLayout, OutlinesDifferAndHaveTheAreaOfADisk) {
    std::vector<std::size_t> corners;
    double length_by_width = 0;
    for (std::uint64_t i = 0; i < 24; ++i) {
        const Region outline = cell_outline(1.6, 0.8, 1, i);
        EXPECT_NEAR(area(outline), pi / 4, 1e-9);
        const Vec2 size = bounds(outline).size();
        length_by_width += size.x / size.y / 24;
        corners.push_back(outline.rings.front().size());
    }
    std::sort(corners.begin(), corners.end());
    EXPECT_EQ(corners.front(), 5U * 4);
    EXPECT_EQ(corners.back(), 8U * 4);
    EXPECT_NEAR(length_by_width, 1.6, 0.25);
}

TEST(GrooveNetwork, AgreesWithExactDistancesToAllRegions) {
    const CellLayout layout = some_cells(0.05);
    const GrooveNetwork network = groove_network(layout, 128, nullptr, {});
    Random random(2, Purpose::test);
    for (int k = 0; k < 400; ++k) {
        // The border's pixels as often as all others together.
        const int x = k % 2 == 0 ? int(random.below(128)) : k % 4 == 1 ? 0 : 127;
        const int y = int(random.below(128));
        const Vec2 p = Vec2(x + 0.5, y + 0.5) * (0.05 / 128);
        std::vector<std::pair<double, std::uint32_t>> nearest;
        for (std::uint32_t c = 0; c < layout.cells.size(); ++c) {
            double least = 1;
            for (int j = -1; j <= 1; ++j)
                for (int i = -1; i <= 1; ++i) {
                    Region region;
                    region.rings = {placed(layout, layout.cells[c], Vec2(i, j))};
                    least = std::min(least, signed_distance(region, p));
                }
            nearest.emplace_back(least, c);
        }
        std::sort(nearest.begin(), nearest.end());
        const std::size_t i = network.index(x, y);
        const double tolerance = 1e-5 * 0.05;
        EXPECT_NEAR(network.distance[i], (nearest[1].first - nearest[0].first) / 2, tolerance);
        EXPECT_NEAR(network.junction[i], (nearest[2].first - nearest[0].first) / 2, tolerance);
        if (nearest[1].first - nearest[0].first > 4 * tolerance) {
            EXPECT_EQ(network.owner[i], nearest[0].second);
        }
    }
}

TEST(Membrane, SolvesItsEquationBetweenStraightGrooves) {
    // Two cells as bands across x, their grooves off the pixels' centres and borders.
    const int n = 128;
    const double low = 20.3, high = 88.6; // of the grooves [pixels]
    GrooveNetwork network;
    network.resolution = n;
    network.pixel = 1;
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            const double at = x + 0.5;
            const bool inner = at > low && at < high;
            network.owner.push_back(inner ? 1 : 0);
            const double to_low = std::abs(at - low), to_high = std::abs(at - high);
            network.distance.push_back(
                static_cast<float>(std::min({to_low, to_high, n - to_low, n - to_high})));
        }
    network.junction = network.along = network.distance;
    for (const double shoulder : {3.0, 12.0, 60.0}) {
        const std::vector<float> u = membrane(network, shoulder, {});
        for (int x = 21; x < 88; ++x) {
            const double from_middle = x + 0.5 - (low + high) / 2;
            const double expected =
                1 - std::cosh(from_middle / shoulder) / std::cosh((high - low) / 2 / shoulder);
            EXPECT_NEAR(u[network.index(x, 40)], expected, 0.006) << shoulder << " at " << x;
        }
    }
}

TEST(ReliefProfiles, AreWhatTheirDocumentsSay) {
    for (const float fullness : {0.0F, 0.5F, 1.0F}) {
        EXPECT_EQ(crista_profile(0, fullness), 0);
        EXPECT_EQ(crista_profile(1, fullness), 1);
        for (int i = 0; i < 100; ++i)
            EXPECT_LT(crista_profile(float(i) / 100, fullness),
                      crista_profile(float(i + 1) / 100, fullness));
    }
    EXPECT_FLOAT_EQ(crista_profile(0.5F, 0), 0.75F);            // parabola
    EXPECT_FLOAT_EQ(crista_profile(0.5F, 1), std::sqrt(0.75F)); // ellipse
    EXPECT_FLOAT_EQ(sulcus_profile(0, 2), 1);
    EXPECT_FLOAT_EQ(sulcus_profile(1, 2), std::exp(-1.0F)); // half the width from the middle
    EXPECT_LT(sulcus_profile(6, 2), 1e-12F);
}

TEST(TileNoise, RepeatsAndHasTheDeviationItSays) {
    const TileNoise noise(7, 5, 3, 1);
    double sum = 0, squares = 0;
    const int count = 200;
    for (int y = 0; y < count; ++y)
        for (int x = 0; x < count; ++x) {
            const Vec2 uv((x + 0.5) / count, (y + 0.5) / count);
            const double v = double(noise(uv));
            EXPECT_LE(std::abs(v), 1.5);
            EXPECT_NEAR(v, noise(uv + Vec2(2, -1)), 1e-5);
            sum += v;
            squares += v * v;
        }
    const double mean = sum / count / count;
    EXPECT_NEAR(mean, 0, 0.1);
    EXPECT_NEAR(std::sqrt(squares / count / count - mean * mean), 1.0 / 3, 0.07);
}

} // namespace
} // namespace scree
