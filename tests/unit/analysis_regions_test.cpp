// SPDX-License-Identifier: GPL-3.0-or-later
// Fill, empty circles and gaps against areas and distances known in closed form or by brute force.
#include "analysis/covered_area.h"
#include "analysis/gaps.h"
#include "analysis/largest_empty_circle.h"
#include "core/canvas.h"
#include "core/random.h"

#include <gtest/gtest.h>

#include <chrono>

namespace scree {
namespace {

Region polygon(std::vector<Ring> rings) { return {std::move(rings), {}, {}}; }

Region box_region(const Vec2& low, const Vec2& high) {
    return polygon({{low, {high.x, low.y}, high, {low.x, high.y}}});
}

Region disk(const Vec2& centre, double radius) {
    return polygon({circle_ring(centre, radius, 256)});
}

PlacedRegions placed(Region domain, bool torus, std::vector<Region> outlines) {
    PlacedRegions regions;
    regions.window = {std::make_shared<Region>(std::move(domain)), torus};
    regions.kind_names = {"thing"};
    for (const Region& outline : outlines) {
        regions.positions.push_back(bounds(outline).center());
        regions.kinds.push_back(0);
    }
    regions.outlines = std::move(outlines);
    return regions;
}

// Crosses of twelve edges at random places, some outside the domain; they may overlap.
PlacedRegions random_crosses(std::size_t count, bool torus, std::uint64_t seed) {
    Random random(seed, Purpose::test);
    std::vector<Region> outlines;
    for (std::size_t i = 0; i < count; ++i) {
        const Vec2 at(random.uniform(0, 2), random.uniform(0, 1));
        const double angle = random.uniform(0, 2 * pi);
        const double size = 0.4 / std::sqrt(double(count));
        Ring ring;
        for (const Vec2& p : {Vec2(1, .3), Vec2(.3, .3), Vec2(.3, 1), Vec2(-.3, 1), Vec2(-.3, .3),
                              Vec2(-1, .3), Vec2(-1, -.3), Vec2(-.3, -.3), Vec2(-.3, -1),
                              Vec2(.3, -1), Vec2(.3, -.3), Vec2(1, -.3)})
            ring.push_back(at + rotate(p * size, angle));
        outlines.push_back(polygon({ring}));
    }
    return placed(box_region({0, 0}, {2, 1}), torus, std::move(outlines));
}

// Brute force: the distance to the nearest of all edges of all images.
double brute_distance(const PlacedRegions& regions, const Vec2& point) {
    double best = std::numeric_limits<double>::infinity();
    const int turns = regions.window.torus ? 2 : 0;
    for (int x = -turns; x <= turns; ++x)
        for (int y = -turns; y <= turns; ++y)
            for (const Region& outline : regions.outlines)
                best = std::min(best, signed_distance(outline, point + Vec2(2.0 * x, y)));
    return best;
}

TEST(CoveredArea, IntersectionsOfKnownShapes) {
    const Region square = box_region({0, 0}, {2, 2});
    EXPECT_DOUBLE_EQ(intersection_area(square, square), 4); // every edge shared
    EXPECT_DOUBLE_EQ(intersection_area(square, box_region({1, 1}, {5, 9})), 1);
    EXPECT_DOUBLE_EQ(intersection_area(square, box_region({2, 0}, {3, 2})), 0); // touching
    EXPECT_DOUBLE_EQ(intersection_area(box_region({0.5, 0.5}, {1, 1}), square), 0.25);
    EXPECT_NEAR(intersection_area(square, polygon({{{1, -1}, {3, 1}, {1, 3}, {-1, 1}}})), 4, 1e-14);
    const Region frame =
        polygon({{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{1, 1}, {1, 3}, {3, 3}, {3, 1}}});
    EXPECT_DOUBLE_EQ(intersection_area(frame, box_region({0, 0}, {2, 2})), 3);
    // Two unit disks one apart: 2 pi / 3 - sqrt(3) / 2, up to the 256 edges.
    EXPECT_NEAR(intersection_area(disk({0, 0}, 1), disk({1, 0}, 1)), 2 * pi / 3 - std::sqrt(3) / 2,
                4e-4);
}

TEST(CoveredArea, OnlyWhatLiesInTheDomainCounts) {
    const Region domain = box_region({0, 0}, {2, 1});
    std::vector<Region> squares{box_region({0.4, 0.4}, {0.6, 0.6}),
                                box_region({-0.1, 0.4}, {0.1, 0.6}),
                                box_region({1.9, 0.9}, {2.1, 1.1}), box_region({3, 3}, {4, 4})};
    EXPECT_NEAR(covered_area(placed(domain, false, squares)), 0.04 + 0.02 + 0.01, 1e-15);
    squares.pop_back();
    EXPECT_NEAR(covered_area(placed(domain, true, squares)), 0.12, 1e-15);
}

TEST(RegionDistance, EqualsBruteForceInThePlaneAndOnATorus) {
    for (const bool torus : {false, true})
        for (const std::size_t count : {1U, 2U, 40U}) {
            const PlacedRegions regions = random_crosses(count, torus, 5);
            const RegionDistance distance(regions);
            Random random(1, Purpose::test);
            for (int i = 0; i < 500; ++i) {
                const Vec2 point(random.uniform(0, 2), random.uniform(0, 1));
                const double expected = brute_distance(regions, point);
                const double found = distance(point);
                // Inside overlapping regions only the sign is defined.
                if (expected > 0)
                    EXPECT_NEAR(found, expected, 1e-12) << torus << " " << count;
                else
                    EXPECT_LE(found, 0);
            }
        }
}

TEST(RegionDistance, ToNeighbour) {
    const Region domain = box_region({0, 0}, {10, 10});
    const std::vector<Region> outlines{box_region({1, 1}, {2, 2}), box_region({2.5, 0}, {3, 10}),
                                       box_region({9, 1}, {9.5, 9})};
    const PlacedRegions plane = placed(domain, false, outlines);
    const RegionDistance in_plane(plane);
    EXPECT_DOUBLE_EQ(in_plane.to_neighbour(0), 0.5);
    EXPECT_DOUBLE_EQ(in_plane.to_neighbour(1), 0.5);
    EXPECT_DOUBLE_EQ(in_plane.to_neighbour(2), 6);
    const PlacedRegions wrapped = placed(domain, true, outlines);
    const RegionDistance on_torus(wrapped);
    EXPECT_DOUBLE_EQ(on_torus.to_neighbour(2), 1.5); // to the first, over the border
    const PlacedRegions lone = placed(domain, true, {outlines[0]});
    EXPECT_DOUBLE_EQ(RegionDistance(lone).to_neighbour(0), 9); // to its own image
    const PlacedRegions alone = placed(domain, false, {outlines[0]});
    EXPECT_TRUE(std::isinf(RegionDistance(alone).to_neighbour(0)));
    // A vertex of the second is near the third, but the nearest to the first is the second.
    const PlacedRegions three = placed(
        domain, false,
        {box_region({0, 0}, {1, 1}), box_region({1.4, 0}, {2, 1}), box_region({2.1, 0}, {3, 1})});
    EXPECT_NEAR(RegionDistance(three).to_neighbour(0), 0.4, 1e-15);
    EXPECT_NEAR(RegionDistance(three).to_neighbour(1), 0.1, 1e-15);
}

TEST(LargestEmptyCircle, KnownOnes) {
    const PlacedRegions empty = placed(box_region({0, 0}, {2, 1}), false, {});
    const Circle whole = largest_empty_circle(empty, RegionDistance(empty));
    EXPECT_NEAR(whole.radius, 0.5, 1e-4);
    // A disk at the corner of a torus: the largest empty circle is in the middle.
    const PlacedRegions corner = placed(box_region({0, 0}, {1, 1}), true, {disk({0, 0}, 0.3)});
    const Circle middle = largest_empty_circle(corner, RegionDistance(corner));
    EXPECT_NEAR(middle.radius, std::sqrt(0.5) - 0.3, 1e-4);
    EXPECT_NEAR((middle.centre - Vec2(0.5, 0.5)).length(), 0, 1e-3);
    const PlacedRegions full =
        placed(box_region({0, 0}, {1, 1}), false, {box_region({-1, -1}, {2, 2})});
    EXPECT_EQ(largest_empty_circle(full, RegionDistance(full)).radius, 0);
}

TEST(LargestEmptyCircle, NoPointOfAFineGridHasMoreRoom) {
    for (const bool torus : {false, true}) {
        const PlacedRegions regions = random_crosses(30, torus, 9);
        const Circle circle = largest_empty_circle(regions, RegionDistance(regions));
        const auto room = [&](const Vec2& p) {
            const double border = torus ? 1 : -signed_distance(*regions.window.domain, p);
            return std::min(border, brute_distance(regions, p));
        };
        EXPECT_NEAR(room(circle.centre), circle.radius, 1e-12);
        constexpr double step = 0.02;
        double best = 0;
        for (int i = 0; i <= 100; ++i)
            for (int k = 0; k <= 50; ++k)
                best = std::max(best, room({i * step, k * step}));
        EXPECT_GE(circle.radius * (1 + 1e-4), best);
        EXPECT_LE(circle.radius, best + step * std::sqrt(0.5)); // distances are 1-Lipschitz
    }
}

TEST(Gaps, DistributionAroundADiskOnATorus) {
    // Points further than d from a disk of radius r in a unit torus: 1 - pi (r + d)^2 of the area.
    const PlacedRegions regions = placed(box_region({0, 0}, {1, 1}), true, {disk({0.1, 0.9}, 0.2)});
    const GapSamples samples = sample_gaps(regions, RegionDistance(regions), 40000);
    EXPECT_EQ(samples.in_window, 40000U);
    const double free = 1 - area(regions.outlines[0]);
    EXPECT_NEAR(double(samples.distances.size()) / 40000, free, 0.002);
    std::size_t beyond = 0;
    for (const double d : samples.distances)
        beyond += d > 0.2 ? 1 : 0;
    EXPECT_NEAR(double(beyond) / 40000, 1 - pi * 0.16, 0.002);
    EXPECT_EQ(sample_gaps(regions, RegionDistance(regions), 40000).distances, samples.distances);
}

TEST(Gaps, SummaryAndHistogram) {
    const Summary s = summary({4, 1, 3, 2, std::numeric_limits<double>::infinity()});
    EXPECT_EQ(s.count, 4U);
    EXPECT_DOUBLE_EQ(s.mean, 2.5);
    EXPECT_DOUBLE_EQ(s.median, 2.5);
    EXPECT_DOUBLE_EQ(s.percentile_95, 3.85);
    EXPECT_DOUBLE_EQ(s.maximum, 4);
    EXPECT_EQ(summary({}).count, 0U);
    const std::vector<double> values{0, 0.4, 0.6, 1.0, 3.0};
    EXPECT_EQ(histogram(values, 1, 2).density, (std::vector<double>{0.8, 0.8}));
}

TEST(Analysis, AHundredThousandRegionsTakeSeconds) {
    const PlacedRegions regions = random_crosses(100000, true, 3);
    const auto start = std::chrono::steady_clock::now();
    const RegionDistance distance(regions);
    const Circle circle = largest_empty_circle(regions, distance);
    const std::vector<double> neighbours = neighbour_distances(regions, distance);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    RecordProperty("seconds", std::to_string(seconds.count()));
    EXPECT_GT(circle.radius, 0);
    EXPECT_EQ(neighbours.size(), 100000U);
    EXPECT_LT(seconds.count(), 120); // takes some seconds with an index, hours without
}

} // namespace
} // namespace scree
