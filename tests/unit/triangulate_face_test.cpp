// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/plane/triangulate_face.h"
#include "geometry/plane/winding_number.h"

#include "core/random.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace scree {
namespace {

using Imath::V3d;

double ring_area(const Ring& ring) { // by trapezoids
    double twice = 0;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Vec2& a = ring[i];
        const Vec2& b = ring[(i + 1) % ring.size()];
        twice += (b.x - a.x) * (a.y + b.y);
    }
    return -twice / 2;
}

// A plane by its origin and axes; the ring's x and y run along u and v.
struct Plane {
    V3d origin, u, v;
    V3d point(const Vec2& p) const { return origin + u * p.x + v * p.y; }
};

std::vector<Plane> planes() {
    const V3d tilted = V3d(1, 2, 3).normalized();
    const V3d across = tilted.cross(V3d(0, 0, 1)).normalized();
    return {{V3d(0.0), V3d(1, 0, 0), V3d(0, 1, 0)},
            {V3d(0.0), V3d(0, 0, 1), V3d(1, 0, 0)},
            {V3d(5, 6, 7), V3d(0, 1, 0), V3d(0, 0, 1)},
            {V3d(-1, 2, 0), V3d(0, 1, 0), V3d(1, 0, 0)}, // seen from behind
            {V3d(5e6, 4e6, 100), across, tilted.cross(across)}};
}

// That the triangles of a ring cover it once and turn as it does: the sum of their areas is the
// ring's, and so is the sum of their areas with signs.
void expect_covered(const std::string& name, const Ring& ring, std::size_t triangles) {
    const double want = ring_area(ring);
    for (const Plane& plane : planes()) {
        std::vector<V3d> corners;
        for (const Vec2& p : ring)
            corners.push_back(plane.point(p));
        const FaceTriangles face = triangulate_face(corners);
        EXPECT_FALSE(face.crosses_itself) << name;
        double sum = 0;
        V3d with_signs(0.0);
        for (const auto& t : face.triangles) {
            const V3d twice = (corners[t[1]] - corners[t[0]]).cross(corners[t[2]] - corners[t[0]]);
            sum += twice.length() / 2;
            with_signs += twice / 2;
        }
        const double tolerance = 1e-7 * std::max(1.0, std::abs(want));
        EXPECT_NEAR(sum, std::abs(want), tolerance) << name;
        EXPECT_NEAR(with_signs.dot(plane.u.cross(plane.v)), want, tolerance) << name;
        if (triangles > 0 && plane.origin.length() < 100) {
            EXPECT_EQ(face.triangles.size(), triangles) << name;
        }
    }
}

Ring comb(int teeth) {
    Ring ring;
    for (int i = 0; i < teeth; ++i) {
        ring.emplace_back(2 * i, 10);
        ring.emplace_back(2 * i, 1);
        ring.emplace_back(2 * i + 1, 1);
        ring.emplace_back(2 * i + 1, 10);
    }
    ring.emplace_back(2 * teeth, 0);
    ring.emplace_back(-1, 0);
    return ring;
}

// Ever longer arms, each turned by a quarter, on the way in a unit inside.
Ring spiral(int turns) {
    Ring out, in;
    for (int i = 0; i < 4 * turns; ++i) {
        const double angle = pi / 2 * i;
        const double radius = 4.0 + i;
        out.push_back(rotate(Vec2(radius, 0), angle));
        in.push_back(rotate(Vec2(radius - 1, 0), angle));
    }
    std::reverse(in.begin(), in.end());
    out.insert(out.end(), in.begin(), in.end());
    return out;
}

TEST(TriangulateFace, CoversTheFaceOnce) {
    struct Row {
        const char* name;
        Ring ring;
        std::size_t triangles; // 0: any number
    };
    const std::vector<Row> rows{
        {"square", {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 2},
        {"arrow, reflex at each corner", {{0, 0}, {2, 1}, {0, 2}, {0.5, 1}}, 2},
        {"arrow from 2", {{2, 1}, {0, 2}, {0.5, 1}, {0, 0}}, 2},
        {"arrow from 3", {{0, 2}, {0.5, 1}, {0, 0}, {2, 1}}, 2},
        {"arrow from 4", {{0.5, 1}, {0, 0}, {2, 1}, {0, 2}}, 2},
        {"triangle with a corner on a side", {{0, 0}, {1, 0}, {2, 0}, {0, 2}}, 2},
        {"square with corners on all sides",
         {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}},
         6},
        {"L", {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 4},
        {"U", {{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}, 6},
        {"first corner again", {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}, 2},
        {"every corner twice", {{0, 0}, {0, 0}, {1, 0}, {1, 0}, {1, 1}, {1, 1}, {0, 1}, {0, 1}}, 2},
        {"triangle and a repeated corner", {{0, 0}, {1, 0}, {1, 0}, {0, 1}}, 1},
        {"whisker", {{0, 0}, {2, 0}, {2, 1}, {4, 1}, {2, 1}, {2, 2}, {0, 2}}, 0},
        {"whisker inwards", {{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 1}, {2, 2}, {0, 2}}, 0},
        {"corners that touch: two squares", // of one corner each
         {{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 1}, {0, 1}},
         4},
        {"corner that touches a side", {{0, 0}, {4, 0}, {4, 2}, {3, 2}, {2, 0}, {1, 2}, {0, 2}}, 0},
        {"hole with a bridge", // 4 x 4 less 2 x 2
         {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}},
         8},
        {"two holes with bridges",
         {{0, 0},
          {7, 0},
          {7, 3},
          {0, 3},
          {0, 0},
          {1, 1},
          {1, 2},
          {2, 2},
          {2, 1},
          {1, 1},
          {0, 0},
          {4, 1},
          {4, 2},
          {5, 2},
          {5, 1},
          {4, 1}},
         0},
        {"sliver", {{0, 0}, {1, 1e-9}, {2, 0}, {1, 2e-9}}, 0},
        {"comb", comb(500), 2000},
        {"spiral", spiral(20), 158},
    };
    for (const Row& row : rows) {
        Ring ring = row.ring;
        expect_covered(row.name, ring, row.triangles);
        std::reverse(ring.begin(), ring.end());
        expect_covered(std::string(row.name) + " reversed", ring, row.triangles);
    }
}

TEST(TriangulateFace, CoversStars) {
    for (std::uint64_t i = 0; i < 200; ++i) {
        Random random(7, Purpose::test, i);
        Ring ring;
        const int corners = 4 + int(60 * random.uniform());
        for (int k = 0; k < corners; ++k)
            ring.push_back(rotate(Vec2(0.05 + random.uniform(), 0), 2 * pi * k / corners));
        expect_covered("star", ring, std::size_t(corners) - 2);
    }
}

// The area of a face that is not plane lies between that of its projection and a little more.
TEST(TriangulateFace, BentFaces) {
    std::vector<V3d> corners;
    for (const Vec2& p : Ring{{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}})
        corners.emplace_back(p.x, 0.05 * p.x * p.y, p.y);
    double sum = 0;
    for (const auto& t : triangulate_face(corners).triangles)
        sum += (corners[t[1]] - corners[t[0]]).cross(corners[t[2]] - corners[t[0]]).length() / 2;
    EXPECT_GT(sum, 7);
    EXPECT_LT(sum, 7.2);
}

TEST(TriangulateFace, FacesWithoutAreaKeepTheirEdges) {
    const std::vector<V3d> line{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1.5, 0, 0}};
    EXPECT_EQ(triangulate_face(line).triangles.size(), 3U);
    EXPECT_EQ(triangulate_face(std::vector<V3d>(6, V3d(1.0))).triangles.size(), 4U);
    EXPECT_FALSE(triangulate_face(line).crosses_itself);
}

TEST(TriangulateFace, TellsOfCrossings) {
    const auto told = [](const Ring& ring) {
        std::vector<V3d> corners;
        for (const Vec2& p : ring)
            corners.emplace_back(p.x, p.y, 0);
        const FaceTriangles first = triangulate_face(corners);
        EXPECT_EQ(first.triangles, triangulate_face(corners).triangles);
        return first.crosses_itself;
    };
    EXPECT_TRUE(told({{0, 0}, {1, 1}, {1, 0}, {0, 1}}));          // no area with signs
    EXPECT_TRUE(told({{0, 0}, {3, 3}, {3, 0}, {0, 1}}));          // some
    EXPECT_TRUE(told({{0, 0}, {4, 0}, {4, 2}, {1, -1}, {0, 2}})); // a corner outside
    EXPECT_TRUE(told({{1, 0}, {-0.809, 0.588}, {0.309, -0.951}, {0.309, 0.951}, {-0.809, -0.588}}));
    EXPECT_FALSE(told({{0, 0}, {4, 0}, {4, 2}, {1, 0}, {0, 2}})); // only touches
}

TEST(WindingNumber, CountsTurns) {
    const Ring square{{0, 0}, {2, 0}, {2, 1}, {0, 1}};
    Ring twice = square;
    twice.insert(twice.end(), square.begin(), square.end());
    const Ring back(square.rbegin(), square.rend());
    for (const bool turned : {false, true}) { // slabs along x, or along y
        const auto seen = [&](Ring ring) {
            for (Vec2& p : ring)
                p = turned ? Vec2(-p.y, p.x) : p;
            return ring;
        };
        const auto turns = [&](const Ring& given, const Vec2& at) {
            const Ring ring = seen(given);
            return WindingNumber(ring)(turned ? Vec2(-at.y, at.x) : at);
        };
        EXPECT_EQ(turns(square, {0.7, 0.3}), 1);
        EXPECT_EQ(turns(back, {0.7, 0.3}), -1);
        EXPECT_EQ(turns(twice, {0.7, 0.3}), 2);
        for (const Vec2& outside : {Vec2(-1, 0.5), Vec2(3, 0.5), Vec2(1, 2), Vec2(1, -2)})
            EXPECT_EQ(turns(twice, outside), 0);
        const Ring eight{{0, 0}, {2, 2}, {2, 0}, {0, 2}};
        EXPECT_EQ(turns(eight, {0.2, 1}), -turns(eight, {1.8, 1}));
        EXPECT_EQ(std::abs(turns(eight, {0.2, 1})), 1);
        EXPECT_EQ(turns(eight, {1, 0.2}), 0);
    }
    // Against all edges of a comb, which has many slabs.
    const Ring ring = comb(300);
    const WindingNumber winding_number(ring);
    for (int i = 0; i < 300; ++i) {
        EXPECT_EQ(winding_number({2 * i + 0.5, 5.5}), 0);
        EXPECT_EQ(winding_number({2 * i + 0.5, 0.5}), -1);
    }
}

} // namespace
} // namespace scree
