// SPDX-License-Identifier: GPL-3.0-or-later
// Strands in the world: where rays meet them, and where they go from there.
#include "render/world/instance_record.h"
#include "render/world/strand_tree.h"
#include "tests/support/strands.h"

#include <gtest/gtest.h>

namespace scree {
namespace {

using test::random_direction;
using test::strand_world;
using test::towards;

// Of constant radius from (0, 0, 0) to (0, 0.8, 0), by steps of 0.2.
Strands straight(float radius) {
    Strands strands;
    test::add_strand(strands, {{0, 0, 0}, {0, 0.2F, 0}, {0, 0.4F, 0}, {0, 0.6F, 0}, {0, 0.8F, 0}},
                     std::vector<float>(5, radius));
    return strands;
}

TEST(Strands, HitsOfAStraightOneAreThoseOfACylinder) {
    const float radius = 0.01F;
    const World world = strand_world(straight(radius), Fibre{});
    EXPECT_EQ(world.strand_figures().strands, 1U);
    EXPECT_EQ(world.strand_figures().segments, 4U);
    EXPECT_EQ(world.triangle_count(), 0U);
    Random random(31, Purpose::test);
    for (int i = 0; i < 5000; ++i) {
        const float height = 0.05F + 0.7F * random.uniform_float();
        const float h = 1.9F * random.uniform_float() - 0.95F;
        const float turn = 2 * pi_f * random.uniform_float();
        const Vec3 side(std::cos(turn), 0, -std::sin(turn));
        const Vec3 forward = Vec3(0, 1, 0).cross(side);
        const Ray ray{Vec3(0, height, 0) + side * (h * radius) - forward * 2, forward};
        Hit hit;
        ASSERT_TRUE(world.hit(ray, hit));
        const float depth = std::sqrt(1 - h * h);
        const Vec3 normal = side * h - forward * depth;
        EXPECT_LT((hit.normal - normal).length(), 1e-3F) << h;
        EXPECT_LT((hit.position - Vec3(0, height, 0) - normal * radius).length(), 1e-3F * radius);
        EXPECT_NEAR(hit.distance, 2 - depth * radius, 0.05F * radius);
        EXPECT_LT((hit.tangent - Vec3(0, 1, 0)).length(), 1e-6F);
        EXPECT_NEAR(hit.uv.x, height / 0.8F, 1e-5F);
        EXPECT_NEAR(std::abs(hit.uv.y - 0.5F), 0.5F * std::abs(h), 1e-3F);
        EXPECT_FLOAT_EQ(hit.uv_per_metre, 1 / std::sqrt(2 * radius * 0.8F));
        EXPECT_FLOAT_EQ(hit.offset, 0.01F * radius);
        EXPECT_FALSE(hit.smooth);
    }
}

// The distance from the surface of the nearest ball, over many balls along the chain.
float off_balls(const Strands& strands, const Vec3& p) {
    constexpr int fine = 2000;
    float nearest = INFINITY;
    for (std::size_t i = 0; i + 1 < strands.points.size(); ++i)
        for (int k = 0; k <= fine; ++k) {
            const float t = static_cast<float>(k) / fine;
            const Vec3 centre = strands.points[i] * (1 - t) + strands.points[i + 1] * t;
            const float radius = strands.radii[i] * (1 - t) + strands.radii[i + 1] * t;
            nearest = std::min(nearest, (p - centre).length() - radius);
        }
    return nearest;
}

// Hits of a strand from all around: at least half of the rays must meet it.
template <class Check>
void for_hits(const World& world, const std::vector<Vec3>& targets, float spread, int count,
              const Check& check) {
    Random random(32, Purpose::test);
    int found = 0;
    for (int i = 0; i < count; ++i) {
        const Vec3& target = targets[random.below(static_cast<std::uint32_t>(targets.size()))];
        const Ray ray =
            towards(random_direction(random) * 4, target + random_direction(random) * spread);
        Hit hit;
        if (!world.hit(ray, hit))
            continue;
        ++found;
        check(ray, hit);
    }
    EXPECT_GT(found, count / 2);
}

TEST(Strands, HitsOfATaperedChainLieOnItsSurface) {
    Strands strands;
    test::add_strand(strands, {{0, 0, 0}, {0.1F, 0.4F, 0}, {0, 0.6F, 0.2F}, {-0.3F, 0.7F, 0}},
                     {0.1F, 0.07F, 0.05F, 0.01F});
    const World world = strand_world(strands, Matte{});
    int creases = 0;
    for_hits(world, strands.points, 0.05F, 400, [&](const Ray& ray, const Hit& hit) {
        EXPECT_NEAR(off_balls(strands, hit.position), 0, 1e-5F);
        // The normal is the direction in which the distance grows; not in the crease of a joint.
        const float further = off_balls(strands, hit.position + hit.normal * 1e-3F);
        creases += std::abs(further - 1e-3F) > 2e-5F ? 1 : 0;
        EXPECT_LT(hit.normal.dot(ray.direction), 0.01F);
        EXPECT_EQ(hit.tangent, Vec3(0.0F)) << "not used by the material";
    });
    EXPECT_LE(creases, 4);
}

TEST(Strands, HitsOfASplineLieOnItsSurface) {
    Strands strands;
    strands.kind = CurveKind::bspline;
    const float radius = 0.02F;
    test::add_strand(strands,
                     {{0, 0, 0}, {0.1F, 0.3F, 0}, {0, 0.6F, 0.2F}, {-0.3F, 0.7F, 0}, {0, 1, 0}},
                     std::vector<float>(5, radius));
    std::vector<Vec3> middle;
    for (int k = 1; k < 20; ++k)
        middle.push_back(
            test::spline_point(&strands.points[k / 10], static_cast<float>(k % 10) / 10));
    float grazing = 0; // how far a normal may point away from the ray
    const auto on_surface = [&](const Ray& ray, const Hit& hit) {
        float nearest = INFINITY;
        Vec3 centre;
        float at = 0;
        for (int piece = 0; piece < 2; ++piece)
            for (int k = 0; k <= 10'000; ++k) {
                const float t = static_cast<float>(k) / 10'000;
                const Vec3 c = test::spline_point(&strands.points[std::size_t(piece)], t);
                if ((hit.position - c).length() < nearest) {
                    nearest = (hit.position - c).length();
                    centre = c;
                    at = (static_cast<float>(piece) + t) / 2;
                }
            }
        EXPECT_NEAR(nearest, radius, 1e-5F);
        EXPECT_GT(hit.normal.dot((hit.position - centre).normalized()), 0.9999F);
        EXPECT_NEAR(hit.uv.x, at, 1e-3F);
        EXPECT_LT(std::abs(hit.tangent.dot(hit.normal)), 1e-3F);
        EXPECT_LT(hit.normal.dot(ray.direction), grazing);
    };
    for (const WorldLimits& limits : {WorldLimits{}, test::no_chords}) {
        const World world = strand_world(strands, Fibre{}, {{}}, {}, limits);
        EXPECT_EQ(world.strand_figures().segments, 2U);
        grazing = limits.most_chords > 0 ? 0.1F : 0.01F; // cones are off by a hundredth of r
        for_hits(world, middle, radius / 2, 1000, on_surface);
    }
}

// A straight spline of constant radius with round ends is a capsule.
TEST(Strands, SplinesAreClosedByHalfBalls) {
    const float radius = 0.1F;
    Strands strands;
    strands.kind = CurveKind::bspline;
    test::add_strand(strands,
                     {{-0.25F, 0, 0}, {0, 0, 0}, {0.25F, 0, 0}, {0.5F, 0, 0}, {0.75F, 0, 0}},
                     std::vector<float>(5, radius)); // from 0 to 0.5
    const auto distance = [&](const Vec3& p) {
        return (p - Vec3(std::clamp(p.x, 0.0F, 0.5F), 0, 0)).length() - radius;
    };
    for (const WorldLimits& limits : {WorldLimits{}, test::no_chords}) {
        const World world = strand_world(strands, Plastic{}, {{}}, {}, limits);
        int on_caps = 0;
        for_hits(world, {Vec3(-0.05F, 0, 0), Vec3(0.55F, 0, 0)}, radius, 4000,
                 [&](const Ray& ray, const Hit& hit) {
                     EXPECT_NEAR(distance(hit.position), 0, 1e-5F);
                     const float t = hit.distance; // sphere tracing is an oracle for convex shapes
                     Vec3 p = ray.origin;
                     for (int i = 0; i < 300; ++i)
                         p += ray.direction * distance(p);
                     EXPECT_NEAR((p - ray.origin).length(), t, 0.02F * radius);
                     on_caps += hit.position.x < 0 || hit.position.x > 0.5F;
                     EXPECT_LT(hit.normal.dot(ray.direction), 0.02F);
                 });
        EXPECT_GT(on_caps, 1000);
        // From inside there is one way out, and nothing between.
        Random random(35, Purpose::test);
        for (int i = 0; i < 1000; ++i) {
            const Ray ray{{0.5F * random.uniform_float(), 0, 0}, random_direction(random)};
            Hit hit;
            ASSERT_TRUE(world.hit(ray, hit));
            EXPECT_NEAR(distance(ray.origin + ray.direction * hit.distance), 0, 0.05F * radius);
            EXPECT_GT(hit.normal.dot(ray.direction), 0);
        }
    }
}

// The two ends of one piece that turns back point the same way: each cap knows its end.
TEST(Strands, CapsKnowTheirEnds) {
    Strands hairpin;
    hairpin.kind = CurveKind::bspline;
    test::add_strand(hairpin, {{-3, 0, 0}, {1, 0, 0}, {1, 0.5F, 0}, {-3, 0.5F, 0}},
                     std::vector<float>(4, 0.01F));
    std::vector<Imath::V4f> vertices;
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec3& p = hairpin.points[i];
        vertices.emplace_back(p.x, p.y, p.z, hairpin.radii[i]);
    }
    const std::uint32_t first = 0;
    StrandTree tree;
    tree.strands = &hairpin;
    tree.vertices = vertices.data();
    tree.firsts = &first;
    tree.caps = end_caps(tree);
    ASSERT_EQ(tree.caps.size(), 2U);
    EXPECT_LT(tree.caps[0].outwards.x, 0);
    EXPECT_LT(tree.caps[1].outwards.x, 0);
    for (std::size_t end = 0; end < 2; ++end) {
        const StrandCap& cap = tree.caps[end];
        EXPECT_EQ(cap.segment, 0U);
        const StrandPoint point = onto_cap(tree, cap, cap.centre + cap.outwards);
        EXPECT_EQ(point.fraction, static_cast<float>(end));
        EXPECT_EQ(point.axis.x < 0, end == 1) << "towards the tip";
        EXPECT_LT((point.normal - cap.outwards).length(), 1e-6F);
    }
}

// How many of `count` rays that leave a random hit outwards meet the segment that they leave.
int met_again(const Strands& strands, const WideMatrix& place, int count) {
    const World world = strand_world(strands, Matte{}, {place});
    Random random(33, Purpose::test);
    int met = 0;
    for (int left = count; left > 0;) {
        const Vec3 target = transform_point(
            place, strands.points[random.below(static_cast<std::uint32_t>(strands.points.size()))]);
        const Ray ray = towards(target + random_direction(random) * 0.5F,
                                target + random_direction(random) * strands.radii.front());
        const RawHit raw = world.find(ray);
        if (!raw.found())
            continue;
        Hit hit;
        world.fill(ray, raw, hit);
        for (int k = 0; k < 10; ++k, --left) {
            Vec3 out = random_direction(random);
            if (out.dot(hit.normal) < 0)
                out = -out;
            const RawHit again = world.find(hit.leave(out));
            met += again.found() && again.primitive == raw.primitive ? 1 : 0;
        }
    }
    return met;
}

TEST(Strands, OutwardRaysDoNotMeetTheirOwnSegment) {
    Random random(34, Purpose::test);
    const Strands gentle = test::random_chains(random, 100, 32, 8e-3F, 1e-3F, 0.2F);
    const Strands bent = test::random_chains(random, 100, 32, 4e-3F, 1e-3F, 1.2F);
    WideMatrix far;
    far.setTranslation(WideVec3(3, -5, 8));
    EXPECT_EQ(met_again(gentle, {}, 300'000), 0);
    EXPECT_EQ(met_again(gentle, far, 200'000), 0);
    EXPECT_EQ(met_again(bent, {}, 300'000), 0);
    EXPECT_EQ(met_again(bent, far, 200'000), 0);
}

TEST(Strands, InstancesCarryStrands) {
    Strands strands = straight(0.05F);
    strands.randoms = {0.75F};
    WideMatrix turned; // y to z, twice as large
    turned.setAxisAngle(WideVec3(1, 0, 0), pi / 2);
    WideMatrix scale;
    scale.setScale(2.0);
    WideMatrix move;
    move.setTranslation(WideVec3(5, 0, 0));
    WideMatrix flat; // an elliptic section
    flat.setScale(WideVec3(3, 1, 1));
    const World world =
        strand_world(strands, Fibre{}, {scale * turned * move, flat}, {0.5F, 0.125F});
    EXPECT_EQ(world.strand_figures().strands, 2U);
    EXPECT_EQ(world.strand_figures().segments, 8U);
    Hit hit;
    ASSERT_TRUE(world.hit({Vec3(5.05F, 3, 0.9F), Vec3(0, -1, 0)}, hit));
    EXPECT_EQ(hit.instance, 0U);
    EXPECT_LT((hit.position - Vec3(5.05F, 0.1F * std::sqrt(0.75F), 0.9F)).length(), 1e-5F);
    EXPECT_LT((hit.tangent - Vec3(0, 0, 1)).length(), 1e-5F);
    EXPECT_FLOAT_EQ(hit.random, 0.25F) << "0.5 + 0.75 less a whole";
    EXPECT_FLOAT_EQ(hit.offset, 0.01F * 0.1F);
    ASSERT_TRUE(world.hit({Vec3(0.09F, 0.3F, 2), Vec3(0, 0, -1)}, hit));
    EXPECT_EQ(hit.instance, 1U);
    EXPECT_LT((hit.position - Vec3(0.09F, 0.3F, 0.04F)).length(), 1e-5F);
    EXPECT_LT((hit.normal - Vec3(0.2F, 0, 0.8F).normalized()).length(), 1e-4F);
    EXPECT_FLOAT_EQ(hit.random, 0.875F);
}

TEST(Strands, StrandsOfUnequalLengthHaveTheirOwnRandomNumbers) {
    Strands strands;
    for (int i = 0; i < 40; ++i) {
        std::vector<Vec3> points;
        for (int k = 0; k <= 1 + (i * i) % 7; ++k)
            points.emplace_back(static_cast<float>(i), static_cast<float>(k), 0.0F);
        test::add_strand(strands, points, std::vector<float>(points.size(), 0.1F));
        strands.randoms.push_back(static_cast<float>(i) / 40);
    }
    const World world = strand_world(strands, Matte{});
    for (int i = 0; i < 40; ++i)
        for (int k = 0; k <= (i * i) % 7; ++k) {
            Hit hit;
            const Vec3 at(static_cast<float>(i), static_cast<float>(k) + 0.5F, 1.0F);
            ASSERT_TRUE(world.hit({at, Vec3(0, 0, -1)}, hit));
            EXPECT_FLOAT_EQ(hit.random, static_cast<float>(i) / 40);
        }
}

TEST(Strands, LightLeavesAFibreOnItsOtherSide) {
    const Ray inside{Vec3(0, 0.3F, 0), Vec3(0, 0.3F, 1).normalized()};
    for (const CurveKind kind : {CurveKind::linear, CurveKind::bspline}) {
        Strands strands = straight(0.05F);
        strands.kind = kind;
        Hit hit;
        EXPECT_FALSE(strand_world(strands, Fibre{}).hit(inside, hit));
        EXPECT_FALSE(strand_world(strands, Fibre{}).occluded(inside));
        ASSERT_TRUE(strand_world(strands, Glass{}).hit(inside, hit)) << "glass has an inside";
        EXPECT_GT(hit.normal.dot(inside.direction), 0.5F);
        EXPECT_NEAR(hit.position.z, 0.05F, 1e-5F);
    }
}

TEST(Strands, TakeLittleMemory) {
    Random random(35, Purpose::test);
    const Strands chains = test::random_chains(random, 4000, 32, 8e-3F, 1e-3F, 0.2F);
    const StrandFigures linear = strand_world(chains, Fibre{}).strand_figures();
    EXPECT_EQ(linear.segments, 128'000U);
    EXPECT_LE(double(linear.bytes) / double(linear.segments), 70);
    // 11 pieces in place of 32 segments.
    const Strands curves =
        test::random_chains(random, 4000, 13, 24e-3F, 1e-3F, 0.5F, CurveKind::bspline);
    const StrandFigures spline =
        strand_world(curves, Fibre{}, {{}}, {}, test::no_chords).strand_figures();
    EXPECT_EQ(spline.segments, 44'000U);
    EXPECT_LE(double(spline.bytes) / 128'000, 36);
    RecordProperty("linear_bytes_per_segment",
                   std::to_string(double(linear.bytes) / double(linear.segments)));
    RecordProperty("bspline_bytes_per_segment", std::to_string(double(spline.bytes) / 128'000));
}

TEST(Strands, FibresAreNotMeshes) {
    test::Stage stage;
    stage.add(test::make_sphere(1, 8), Fibre{});
    try {
        const World world(stage.aggregates, {});
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.diagnostics().front().message, " is a mesh; material.fibre is for strands");
    }
}

} // namespace
} // namespace scree
