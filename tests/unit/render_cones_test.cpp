// SPDX-License-Identifier: GPL-3.0-or-later
// Splines that are chains of cones in Embree's tree.
#include "render/world/strand_tree.h"
#include "tests/support/strands.h"

#include <gtest/gtest.h>

namespace scree {
namespace {

using test::random_direction;
using test::strand_world;
using test::towards;

// Chains of cones lie as near to their splines as they should, and follow them from end to end.
TEST(Strands, ConesFollowTheirSplines) {
    Random random(36, Purpose::test);
    for (const float bend : {0.05F, 0.5F, 1.5F}) {
        const float radius = 2e-3F;
        const Strands curves =
            test::random_chains(random, 30, 12, 8e-3F, radius, bend, CurveKind::bspline);
        const std::vector<std::uint16_t> counts = chord_counts(curves, 1'000'000);
        ASSERT_EQ(counts.size(), curves.segment_count());
        std::size_t piece = 0;
        float farthest = 0;
        for (std::size_t strand = 0; strand < curves.count(); ++strand)
            for (std::uint32_t i = curves.offsets[strand]; i + 3 < curves.offsets[strand + 1];
                 ++i, ++piece)
                for (int k = 0; k < counts[piece]; ++k) {
                    const auto at = [&](float t) {
                        return test::spline_point(&curves.points[i],
                                                  (static_cast<float>(k) + t) / counts[piece]);
                    };
                    const Vec3 a = at(0), side = at(1) - a;
                    for (int j = 1; j < 10; ++j) {
                        const Vec3 off = at(static_cast<float>(j) / 10) - a;
                        farthest = std::max(
                            farthest, (off - side * (off.dot(side) / side.dot(side))).length());
                    }
                }
        EXPECT_LE(farthest, 1.001F * chord_tolerance * radius) << bend;
        EXPECT_GE(farthest, 0.1F * chord_tolerance * radius) << "no more cones than needed";
        EXPECT_TRUE(chord_counts(curves, curves.segment_count() - 1).empty());
    }
}

// A ray that leaves outwards meets its own spline again only across a bend.
TEST(Strands, OutwardRaysLeaveTheConesOfTheirSpline) {
    Random random(37, Purpose::test);
    const float radius = 1e-3F;
    int tried = 0;
    for (int strand = 0; strand < 60; ++strand) {
        const Strands curve =
            test::random_chains(random, 1, 12, 8e-3F, radius, 0.3F, CurveKind::bspline);
        const World world = strand_world(curve, Matte{});
        for (int i = 0; i < 1000; ++i) {
            const Vec3 target = curve.points[random.below(13)];
            Hit hit;
            if (!world.hit(towards(target + random_direction(random) * 0.5F,
                                   target + random_direction(random) * radius),
                           hit))
                continue;
            Vec3 out = random_direction(random);
            out = out.dot(hit.normal) < 0 ? -out : out;
            Ray leaving = hit.leave(out);
            leaving.length = 0.3F * radius;
            EXPECT_FALSE(world.occluded(leaving)) << out.dot(hit.normal);
            ++tried;
        }
    }
    EXPECT_GT(tried, 10'000);
}

} // namespace
} // namespace scree
