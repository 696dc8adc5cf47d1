// SPDX-License-Identifier: GPL-3.0-or-later
// The parts of the search for room against brute force: convex covers, no-fit polygons of
// intervals of angles and scales, and what they leave of an area.
#include "core/random.h"
#include "generators/layout/open_area.h"
#include "geometry/figures/convex_cover.h"
#include "geometry/plane/region_shapes.h"
#include "geometry/plane/region_tools.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace scree {

namespace {

bool holds(const Ring& convex, const Vec2& p, double tolerance) {
    for (std::size_t i = 0, j = convex.size() - 1; i < convex.size(); j = i++)
        if (cross((convex[i] - convex[j]).normalized(), p - convex[j]) < -tolerance)
            return false;
    return true;
}

Vec2 random_point(Random& random, const Box2& box) {
    return {random.uniform(box.min.x, box.max.x), random.uniform(box.min.y, box.max.y)};
}

/// A simple polygon: a star of uneven rays.
Ring uneven_star(Random& random, int corners) {
    Ring ring;
    for (int i = 0; i < corners; ++i)
        ring.push_back(rotate({random.uniform(0.2, 1), 0}, 2 * pi * i / corners));
    return ring;
}

Ring convex_ring(Random& random) {
    const int corners = 3 + int(random.below(5));
    const double first = random.uniform(0, 2 * pi);
    const Vec2 centre(random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5));
    Ring ring; // on an ellipse, so convex
    for (int i = 0; i < corners; ++i) {
        const Vec2 p = rotate({1, 0}, first + 2 * pi * (i + random.uniform(0, 0.8)) / corners);
        ring.push_back(centre + p * Vec2(0.6, 0.2));
    }
    return ring;
}

TEST(ConvexCover, CoversTheRegionAndNoMore) {
    Random random(1, Purpose::test);
    for (int trial = 0; trial < 40; ++trial) {
        std::vector<Ring> rings = {uneven_star(random, 4 + int(random.below(20)))};
        if (trial % 2 == 1) {
            Ring hole = circle_ring(0.1, 8);
            std::reverse(hole.begin(), hole.end());
            rings.push_back(hole);
        }
        const Region region = triangulate(rings);
        const std::vector<Ring> cover = convex_cover(region);
        for (const Ring& part : cover) {
            for (std::size_t i = 0; i < part.size(); ++i) {
                const Vec2& a = part[i];
                const Vec2& b = part[(i + 1) % part.size()];
                EXPECT_GE(cross(b - a, part[(i + 2) % part.size()] - b), 0);
                // Slightly inside, since it may share the outline.
                EXPECT_LT(signed_distance(region, a), 1e-6);
                EXPECT_LT(signed_distance(region, (a + b) * 0.5), 1e-6);
            }
        }
        for (int i = 0; i < 2000; ++i) {
            const Vec2 p = random_point(random, bounds(region));
            const bool covered =
                std::ranges::any_of(cover, [&](const Ring& part) { return holds(part, p, 1e-9); });
            if (std::abs(signed_distance(region, p)) > 1e-6) {
                ASSERT_EQ(covered, contains(region, p));
            }
        }
    }
}

TEST(ConvexCover, TheArmsOfAnLAreItsPieces) {
    const std::vector<Ring> cover = convex_cover(triangulate({l_ring(1, 0.3)}));
    ASSERT_EQ(cover.size(), 2U);
    EXPECT_NEAR(signed_area(cover[0]), 0.3, 1e-9); // both arms in full length
    EXPECT_NEAR(signed_area(cover[1]), 0.3, 1e-9);
}

TEST(ConvexCover, PartitionAddsUp) {
    for (const Ring& ring : {u_ring(1, 0.25), star_ring(0.5, 0.4, 7), circle_ring(1, 30)}) {
        const Region region = triangulate({ring});
        double sum = 0;
        for (const Ring& part : convex_partition(region))
            sum += signed_area(part);
        EXPECT_NEAR(sum, area(region), 1e-9);
    }
}

TEST(ConvexCover, SimplifiedInwardStaysInsideAndNear) {
    const Ring circle = circle_ring(1, 100);
    for (const double tolerance : {0.003, 0.01, 0.1}) {
        const Ring simple = simplify_inward(circle, tolerance);
        EXPECT_LT(simple.size(), circle.size());
        for (const Vec2& v : simple)
            EXPECT_NE(std::ranges::find(circle, v), circle.end());
        double farthest = 0;
        for (const Vec2& v : circle) {
            double nearest = std::numeric_limits<double>::infinity();
            for (std::size_t i = 0; i < simple.size(); ++i)
                nearest = std::min(nearest,
                                   segment_distance(v, simple[i], simple[(i + 1) % simple.size()]));
            farthest = std::max(farthest, nearest);
        }
        EXPECT_LE(farthest, tolerance * 1.000001);
    }
}

TEST(Kernel, KnowsStarShapes) {
    const Ring corner = kernel(triangulate({l_ring(1, 0.3)}));
    ASSERT_FALSE(corner.empty());
    EXPECT_NEAR(signed_area(corner), 0.09, 1e-9); // the square where the arms meet
    EXPECT_TRUE(kernel(triangulate({u_ring(1, 0.25)})).empty());
    EXPECT_NEAR(signed_area(kernel(triangulate({circle_ring(1, 12)}))),
                signed_area(circle_ring(1, 12)), 1e-9);
}

/// Distance of two convex polygons by brute force, 0 where they overlap.
double distance(const Ring& a, const Ring& b) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j) {
            const Vec2 &p = a[i], &q = a[(i + 1) % a.size()], &r = b[j], &s = b[(j + 1) % b.size()];
            if ((cross(q - p, r - p) > 0) != (cross(q - p, s - p) > 0) &&
                (cross(s - r, p - r) > 0) != (cross(s - r, q - r) > 0))
                return 0;
            nearest = std::min({nearest, segment_distance(p, r, s), segment_distance(r, p, q)});
        }
    return holds(a, b[0], 0) || holds(b, a[0], 0) ? 0 : nearest;
}

Ring placed(const Ring& ring, const Vec2& position, double angle, double scale) {
    Ring result;
    for (const Vec2& v : ring)
        result.push_back(position + rotate(v, angle) * scale);
    return result;
}

bool holds(const HalfPlanes& polygon, const Vec2f& p) {
    for (std::size_t q = 0; q < polygon.offset.size(); ++q)
        for (int lane = 0; lane < 4; ++lane)
            if (polygon.normal_x[q][lane] * p.x + polygon.normal_y[q][lane] * p.y >
                polygon.offset[q][lane])
                return false;
    return true;
}

struct Interval {
    double angle, half_angle, low, high;
};

TEST(NoFit, NothingOfItIsFartherThanTheClearance) {
    Random random(2, Purpose::test);
    std::size_t inside = 0, near = 0;
    for (int trial = 0; trial < 1500; ++trial) {
        const Ring a = convex_ring(random), b = convex_ring(random);
        const NoFitPiece piece_a(a, pi / 2), piece_b(b, pi / 2);
        const double half = std::exp2(random.uniform(-8, 0)) * 0.7;
        const double low = random.uniform(0.5, 1);
        const Interval v{random.uniform(0, 2 * pi), half, low, low * random.uniform(1, 1.2)};
        const double clearance = trial % 3 == 0 ? 0 : random.uniform(0, 0.1);
        PiecePool moving, fixed;
        moving.add(piece_a, std::cos(v.angle), std::sin(v.angle), 1, {0, 0});
        fixed.add(piece_b, 1, 0, 1, {0, 0});
        HalfPlanes polygon;
        const Imath::Box2f box(Vec2f(-3), Vec2f(3));
        const TurnInterval turn{float(std::cos(half)), float(std::sin(half)), float(v.low),
                                float(v.high)};
        const double blunt = std::max(piece_a.corner_cosine, piece_b.corner_cosine);
        if (no_fit(moving, moving[0], turn, fixed, fixed[0], float(blunt * clearance),
                   float(clearance), box, polygon) != NoFit::found)
            continue;
        for (int i = 0; i < 60; ++i) {
            const Vec2 p = random_point(random, {Vec2(-1.2), Vec2(1.2)});
            if (!holds(polygon, Vec2f(p)))
                continue;
            ++inside;
            for (int k = 0; k < 12; ++k) {
                // Ends of the interval first: the bounds are tight there.
                const double angle = v.angle + half * (k < 2 ? 2 * k - 1 : random.uniform(-1, 1));
                const double scale = k % 3 == 0   ? v.low
                                     : k % 3 == 1 ? v.high
                                                  : random.uniform(v.low, v.high);
                const double d = distance(placed(a, p, angle, scale), b);
                ASSERT_LE(d, clearance + 1e-5);
                near += d > 0 ? 1 : 0;
            }
        }
    }
    EXPECT_GT(inside, 1000U);
    EXPECT_GT(near, 50U); // the clearance is made use of
}

TEST(NoFit, ApproachesTheExactSetAsTheIntervalShrinks) {
    Random random(3, Purpose::test);
    std::size_t overlaps = 0;
    for (int trial = 0; trial < 400; ++trial) {
        const Ring a = convex_ring(random), b = convex_ring(random);
        const NoFitPiece piece_a(a, pi / 2), piece_b(b, pi / 2);
        const double angle = random.uniform(0, 2 * pi);
        PiecePool moving, fixed;
        moving.add(piece_a, std::cos(angle), std::sin(angle), 1, {0, 0});
        fixed.add(piece_b, 1, 0, 1, {0, 0});
        const double half = 1e-5;
        const TurnInterval turn{float(std::cos(half)), float(std::sin(half)), 1, 1};
        for (int i = 0; i < 50; ++i) {
            const Vec2 p = random_point(random, {Vec2(-1.2), Vec2(1.2)});
            if (distance(placed(a, p, angle, 1), b) > 0)
                continue;
            // Deep enough that an overlap remains after a move by 1e-3 in any direction.
            bool deep = true;
            for (int k = 0; k < 8; ++k)
                deep = deep &&
                       distance(placed(a, p + rotate({1e-3, 0}, k * pi / 4), angle, 1), b) == 0;
            if (!deep)
                continue;
            ++overlaps;
            HalfPlanes polygon;
            const Imath::Box2f box(Vec2f{p} - Vec2f(1e-4F), Vec2f{p} + Vec2f(1e-4F));
            ASSERT_EQ(no_fit(moving, moving[0], turn, fixed, fixed[0], 0, 0, box, polygon),
                      NoFit::found);
            ASSERT_TRUE(holds(polygon, Vec2f(p)));
        }
    }
    EXPECT_GT(overlaps, 500U);
}

TEST(NoFit, SaysNeverOnlyWhereItNeverReaches) {
    Random random(4, Purpose::test);
    std::size_t never = 0;
    for (int trial = 0; trial < 4000; ++trial) {
        const Ring a = convex_ring(random), b = convex_ring(random);
        const NoFitPiece piece_a(a, pi / 2), piece_b(b, pi / 2);
        const double angle = random.uniform(0, 2 * pi), half = random.uniform(0, 0.5);
        PiecePool moving, fixed;
        moving.add(piece_a, std::cos(angle), std::sin(angle), 1, {0, 0});
        fixed.add(piece_b, 1, 0, 1, {0, 0});
        const TurnInterval turn{float(std::cos(half)), float(std::sin(half)), 0.8F, 1.1F};
        const Vec2 corner = random_point(random, {Vec2(-1.5), Vec2(1.5)});
        const Imath::Box2f box(Vec2f{corner}, Vec2f{corner} + Vec2f(0.3F));
        HalfPlanes polygon;
        if (no_fit(moving, moving[0], turn, fixed, fixed[0], 0, 0, box, polygon) != NoFit::never)
            continue;
        ++never;
        for (int i = 0; i < 30; ++i) {
            const Vec2 p = corner + random_point(random, {Vec2(0), Vec2(0.3)});
            const double turned = angle + half * random.uniform(-1, 1);
            ASSERT_GT(distance(placed(a, p, turned, random.uniform(0.8, 1.1)), b), 0);
        }
    }
    EXPECT_GT(never, 500U);
}

bool holds(const Fragment& f, const Vec2f& p, float tolerance) {
    for (int i = 0; i < f.count; ++i) {
        const auto a = std::size_t(i), b = std::size_t((i + 1) % f.count);
        const Vec2f along = Vec2f(f.x[b] - f.x[a], f.y[b] - f.y[a]).normalized();
        if (along.x * (p.y - f.y[a]) - along.y * (p.x - f.x[a]) < -tolerance)
            return false;
    }
    return f.count >= 3;
}

TEST(OpenArea, WhatIsLeftIsWhatThePolygonDoesNotHold) {
    Random random(5, Purpose::test);
    std::size_t taken = 0;
    for (int trial = 0; trial < 1000; ++trial) {
        const NoFitPiece piece(convex_ring(random), pi);
        PiecePool pool;
        pool.add(piece, 1, 0, 1, {0, 0});
        HalfPlanes polygon;
        for (std::uint32_t q = 0; q < pool[0].quads; ++q) {
            polygon.normal_x.push_back(pool.normal_x(pool[0])[q]);
            polygon.normal_y.push_back(pool.normal_y(pool[0])[q]);
            polygon.offset.push_back(pool.offset(pool[0])[q]);
        }
        const Vec2f corner(random_point(random, {Vec2(-1), Vec2(0.5)}));
        const Fragment box = box_fragment({corner, corner + Vec2f(0.7F)});
        std::vector<Fragment> rest;
        if (!subtract(box, polygon, 0, rest)) {
            EXPECT_TRUE(rest.empty());
            rest.push_back(box);
        } else {
            ++taken;
        }
        for (int i = 0; i < 200; ++i) {
            const Vec2f p = box.at(random.uniform_float(), random.uniform_float());
            int in = 0;
            bool doubtful = false;
            for (const Fragment& f : rest) {
                in += holds(f, p, 0) ? 1 : 0;
                doubtful = doubtful || holds(f, p, 1e-5F) != holds(f, p, -1e-5F);
            }
            if (doubtful)
                continue;
            ASSERT_LE(in, 1); // they do not overlap
            ASSERT_EQ(in == 0, holds(polygon, p));
        }
    }
    EXPECT_GT(taken, 300U);
}

TEST(OpenArea, PointsAreUniform) {
    Fragment f; // a trapezium, twice as wide below as above
    f.add(0, 0);
    f.add(2, 0);
    f.add(1.5F, 1);
    f.add(0.5F, 1);
    f.close();
    EXPECT_FLOAT_EQ(f.area(), 1.5F);
    EXPECT_NEAR(f.centroid().y, 4.0 / 9, 1e-6);
    Random random(6, Purpose::test);
    constexpr int count = 40000;
    double below = 0, left = 0;
    for (int i = 0; i < count; ++i) {
        const Vec2f p = f.at(random.uniform_float(), random.uniform_float());
        ASSERT_TRUE(holds(f, p, 1e-5F));
        below += p.y < 0.5F ? 1 : 0;
        left += p.x < 1 ? 1 : 0;
    }
    // Four standard deviations.
    EXPECT_NEAR(below / count, 0.875 / 1.5, 4 * std::sqrt(0.25 / count));
    EXPECT_NEAR(left / count, 0.5, 4 * std::sqrt(0.25 / count));
}

} // namespace

} // namespace scree
