// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/world/support_function.h"

#include "core/random.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace scree {
namespace {

double exact_reach(const std::vector<Vec3>& points, const Vec3& direction) {
    double most = -1e30;
    for (const Vec3& p : points)
        most = std::max(most, Imath::V3d(p).dot(Imath::V3d(direction)));
    return most;
}

std::vector<Vec3> cloud(Random& random, std::size_t count, const Vec3& stretch, const Vec3& at) {
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < count; ++i)
        points.push_back(at + stretch * Vec3(random.uniform_float() - 0.5F,
                                             random.uniform_float() - 0.5F,
                                             random.uniform_float() - 0.5F));
    return points;
}

// From below by the true reach, from above by a fifth of the size more, for points far from and
// around the origin, round and flat, and for directions along the axes and anywhere.
TEST(SupportFunction, IsABoundAndATightOne) {
    Random random(1, Purpose::test);
    const Vec3 stretches[] = {{1, 1, 1}, {2, 0.01F, 1}, {1, 0, 0}};
    const Vec3 centres[] = {{0, 0, 0}, {3, -2, 1}};
    for (const Vec3& stretch : stretches)
        for (const Vec3& centre : centres)
            for (const std::size_t count : {1U, 7U, 1000U}) {
                const std::vector<Vec3> points = cloud(random, count, stretch, centre);
                const SupportFunction support{points};
                ASSERT_TRUE(support.known());
                double farthest = 0; // from the origin
                double extent = 0;   // around the middle
                for (const Vec3& p : points) {
                    farthest = std::max(farthest, double(p.length()));
                    extent = std::max(extent, double((p - centre).length()));
                }
                for (int i = 0; i < 3000; ++i) {
                    Vec3 d(random.uniform_float() - 0.5F, random.uniform_float() - 0.5F,
                           random.uniform_float() - 0.5F);
                    if (i < 27)
                        d = Vec3(float(i % 3 - 1), float(i / 3 % 3 - 1), float(i / 9 - 1));
                    const double length = double(d.length());
                    const double rounding = 1e-6 * farthest * length;
                    EXPECT_GE(support(d), exact_reach(points, d) - rounding);
                    EXPECT_LE(support(d),
                              exact_reach(points, d) + 0.2 * extent * length + rounding);
                }
            }
}

TEST(SupportFunction, OfNothingIsUnknown) {
    EXPECT_FALSE(SupportFunction().known());
    EXPECT_FALSE(SupportFunction(std::span<const Vec3>{}).known());
}

} // namespace
} // namespace scree
