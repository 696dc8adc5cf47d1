// SPDX-License-Identifier: GPL-3.0-or-later
// generator.fibres: how fibres grow, where they are placed, and how they are fitted into a target.
#include "core/device.h"
#include "core/parallel.h"
#include "generators/fibres/adjustment.h"
#include "generators/fibres/fibre_source.h"
#include "tests/support/fibres.h"

#include <gtest/gtest.h>

#include <cstring>

namespace scree {
namespace {

using namespace fibres;
using tests::bake_fibres;
using tests::FibreValues;
using tests::strands_of;

/// Fibres as grown and placed, in a ball of diameter 2.
FibreValues grown() {
    return {{"target", tests::ball_target(1)},
            {"count", std::int64_t{500}},
            {"adjustment", std::string("none")},
            {"contact", false}};
}

std::shared_ptr<const Strands> bake(const FibreValues& values) {
    return strands_of(bake_fibres(values));
}

Range in_degrees(double low, double high) { return {radians(low), radians(high)}; }

TEST(Fibres, AreChainsOfEqualSegments) {
    FibreValues values = grown();
    values["length"] = Range{0.4, 0.8};
    values["segments"] = std::int64_t{16};
    values["taper"] = 0.25;
    const auto strands = bake(values);
    ASSERT_EQ(strands->count(), 500U);
    ASSERT_EQ(strands->points.size(), 500U * 17);
    EXPECT_LT(tests::stretch(*strands), 1e-5);
    double shortest = 1;
    double longest = 0;
    double sum = 0;
    for (std::size_t f = 0; f < strands->count(); ++f) {
        const auto points = tests::strand(*strands, f);
        const double length = 16 * double((points[1] - points[0]).length());
        shortest = std::min(shortest, length);
        longest = std::max(longest, length);
        sum += length;
        const Vec3 along = (points[1] - points[0]).normalized();
        EXPECT_NEAR(strands->normals[f].dot(along), 0, 1e-5);
        EXPECT_NEAR(strands->normals[f].length(), 1, 1e-5);
    }
    EXPECT_NEAR(shortest, 0.4, 0.004);
    EXPECT_NEAR(longest, 0.8, 0.004);
    EXPECT_NEAR(sum / 500, 0.6, 0.02);
    EXPECT_FLOAT_EQ(strands->radii[0], 0.8F / 250);
    EXPECT_FLOAT_EQ(strands->radii[8], 0.625F * 0.8F / 250);
    EXPECT_FLOAT_EQ(strands->radii[16], 0.25F * 0.8F / 250);
}

TEST(Fibres, TurnByAnglesUniformInTheirRange) {
    FibreValues values = grown();
    values["theta"] = in_degrees(-10.8, 10.8);
    const auto strands = bake(values);
    std::array<int, 4> quarters{};
    for (std::size_t f = 0; f < strands->count(); ++f)
        for (std::size_t i = 1; i < 32; ++i) {
            const double angle = degrees(tests::joint_angle(tests::strand(*strands, f), i));
            ASSERT_LE(angle, 10.81);
            ++quarters[std::size_t(std::min(3.0, angle / 2.7))];
        }
    for (const int count : quarters)
        EXPECT_NEAR(count, 500 * 31 / 4.0, 200); // four standard deviations
}

TEST(Fibres, AreStraightArcsOrHelicesByTheirAngles) {
    FibreValues values = grown();
    values["theta"] = in_degrees(0, 0);
    for (std::size_t i = 1; const auto& strands : {bake(values)})
        EXPECT_NEAR(tests::joint_angle(tests::strand(*strands, 3), i), 0, 1e-3);
    values["theta"] = in_degrees(9, 9);
    const auto arcs = bake(values); // 31 turns of 9 degrees, in a plane
    const auto arc = tests::strand(*arcs, 7);
    const WideVec3 plane = WideVec3(arc[1] - arc[0]).cross(WideVec3(arc[9] - arc[8])).normalized();
    for (std::size_t i = 1; i < 32; ++i) {
        EXPECT_NEAR(degrees(tests::joint_angle(arc, i)), 9, 0.01);
        EXPECT_NEAR(WideVec3(arc[i] - arc[0]).dot(plane), 0, 1e-5);
    }
    values["phi"] = in_degrees(20, 20);
    const auto helices = bake(values);
    const auto helix = tests::strand(*helices, 7);
    const double chord = double((helix[3] - helix[0]).length());
    double off_plane = 0;
    for (std::size_t i = 3; i <= 32; ++i) {
        EXPECT_NEAR(double((helix[i] - helix[i - 3]).length()), chord, 1e-5);
        const WideVec3 normal =
            WideVec3(helix[1] - helix[0]).cross(WideVec3(helix[2] - helix[1])).normalized();
        off_plane = std::max(off_plane, std::abs(WideVec3(helix[i] - helix[0]).dot(normal)));
    }
    EXPECT_GT(off_plane, 0.05);
}

TEST(Fibres, PointEverywhereAndLieInTheTarget) {
    FibreValues values = grown();
    values["count"] = std::int64_t{4000};
    const auto strands = bake(values);
    WideVec3 direction(0.0);
    double inner = 0; // centroids in the half of the volume that is farther in
    for (std::size_t f = 0; f < strands->count(); ++f) {
        const auto points = tests::strand(*strands, f);
        direction += WideVec3((points[1] - points[0]).normalized()) / 4000;
        const double distance = (tests::centroid(points) - WideVec3(0, 1, 0)).length();
        EXPECT_LE(distance, 1 - 0.004 + 1e-3);
        inner += distance < std::cbrt(0.5) * (1 - 0.004);
    }
    EXPECT_LT(direction.length(), 4 / std::sqrt(4000.0));
    EXPECT_NEAR(inner, 2000, 4 * std::sqrt(1000.0));
}

TEST(Fibres, BecomeSplinesAboutThreeSegmentsAPiece) {
    FibreValues values = grown();
    values["count"] = std::int64_t{50};
    values["theta"] = in_degrees(2, 2); // a gentle arc, close to any smooth curve through it
    values["taper"] = 0.5;
    values["curve"] = std::string("bspline");
    const Aggregate of_32 = bake_fibres(values);
    EXPECT_EQ(strands_of(of_32)->kind, CurveKind::bspline);
    EXPECT_EQ(strands_of(of_32)->points.size(), 50U * 14); // 11 pieces
    EXPECT_LE(tests::fact(of_32, "curve_excess"), 0.05);

    values["segments"] = std::int64_t{30}; // 10 pieces, through every third vertex
    const auto splines = strands_of(bake_fibres(values));
    values["curve"] = std::string("linear");
    const auto chains = bake(values);
    for (std::size_t f = 0; f < 50; ++f)
        for (std::size_t i = 0; i <= 10; ++i) {
            const auto control = tests::strand(*splines, f).subspan(i, 3);
            const Vec3 on_curve = (control[0] + control[1] * 4.0F + control[2]) / 6.0F;
            EXPECT_LT((on_curve - tests::strand(*chains, f)[3 * i]).length(), 1e-5F);
            const float* radii = &splines->radii[f * 13 + i];
            EXPECT_NEAR((radii[0] + 4 * radii[1] + radii[2]) / 6, chains->radii[f * 31 + 3 * i],
                        1e-7F);
        }
}

TEST(Fibres, FollowAFlow) {
    FibreValues values = grown();
    const auto angle = [](double heading) {
        return SharedObject(std::shared_ptr<const Field>(std::make_shared<ConstantField>(heading)));
    };
    const auto along = [](const Strands& strands) { // mean cosine to +z
        double sum = 0;
        for (std::size_t f = 0; f < strands.count(); ++f) {
            const auto points = tests::strand(strands, f);
            sum += double((points.back() - points.front()).normalized().z);
        }
        return sum / double(strands.count());
    };
    EXPECT_NEAR(along(*bake(values)), 0, 0.1);
    values["flow"] = angle(90);
    values["flow_strength"] = 0.3;
    EXPECT_GT(along(*bake(values)), 0.9);
    values["flow_strength"] = 1.0;
    EXPECT_GT(along(*bake(values)), 0.99);
}

TEST(Fibres, BeginOnRootsAlongTheNormal) {
    const Aggregate hair = bake_fibres({{"roots", tests::ball_target(1)},
                                        {"count", std::int64_t{300}},
                                        {"length", Range{0.3, 0.3}},
                                        {"segments", std::int64_t{12}}});
    const auto strands = strands_of(hair);
    EXPECT_GT(tests::fact(hair, "root_spacing"), 20);
    EXPECT_LE(tests::fact(hair, "deepest"), 0.05);
    EXPECT_LE(tests::fact(hair, "outside"), 0.05);
    for (std::size_t f = 0; f < 300; ++f) {
        const auto points = tests::strand(*strands, f);
        const Vec3 out = points[0] - Vec3(0, 1, 0);
        EXPECT_NEAR(out.length(), 1, 4e-3F); // of a sphere with facets
        EXPECT_GT((points[1] - points[0]).normalized().dot(out), 0.99F);
    }
}

TEST(Fibres, EachHasAStreamOfItsOwn) {
    FibreValues values = grown();
    const auto many = bake(values);
    values["count"] = std::int64_t{100};
    const auto few = bake(values);
    EXPECT_TRUE(std::equal(few->points.begin(), few->points.end(), many->points.begin()));
    values["seed"] = std::int64_t{2};
    EXPECT_NE(bake(values)->points[0], few->points[0]);
}

class Adjustment : public testing::Test {
  protected:
    std::shared_ptr<const Mesh> target =
        std::make_shared<const Mesh>(tests::component_mesh("duck", {{"length", 2.0}}));
    SignedDistanceGrid grid{*target, 0.02, 0, std::size_t{1} << 22, 0.2};
    FibresSettings settings = [] {
        FibresSettings made;
        made.count = 300;
        made.shape = {.segments = 32,
                      .length = {0.8, 0.8},
                      .radius = 0.004,
                      .theta = in_degrees(-10.8, 10.8)};
        return made;
    }();
    Interior interior{grid, settings.shape.radius};
    RigidFibres placed = FibreSource(settings, &interior, nullptr).place_all().rigid;

    Vec3 vertex(const RigidFibres& fibres, std::size_t f, std::size_t v) const {
        const Pose& pose = fibres.poses[f];
        return pose.centre + rotated(pose.rotation, fibres.local[f * fibres.vertices + v]);
    }
    /// Half the sum of max(0, distance + 1.05 radius)^2.
    double cost(const RigidFibres& fibres, std::size_t f) const {
        double sum = 0;
        for (std::size_t v = 0; v < fibres.vertices; ++v) {
            const double d =
                std::max(0.0, double(grid.at(vertex(fibres, f, v))) + 1.05 * settings.shape.radius);
            sum += d * d / 2;
        }
        return sum;
    }
};

TEST_F(Adjustment, NearestBringsFibresIn) {
    RigidFibres fitted = placed;
    EXPECT_LE(adjust_nearest(fitted, grid, settings.shape.radius, {}), 35);
    double before = 0;
    double after = 0;
    for (std::size_t f = 0; f < settings.count; ++f) {
        before += cost(placed, f);
        after += cost(fitted, f);
    }
    EXPECT_LT(after, 0.002 * before);
}

TEST_F(Adjustment, NearestFindsWhatSmallMovesCannotBetter) {
    RigidFibres fitted = placed;
    adjust_nearest(fitted, grid, settings.shape.radius, {});
    int worse = 0;
    for (std::size_t f = 0; f < settings.count; ++f) {
        const double least = cost(fitted, f);
        for (int move = 0; move < 12; ++move) {
            RigidFibres tried{.vertices = fitted.vertices};
            tried.local.assign(fitted.local.begin() + std::ptrdiff_t(f * 33),
                               fitted.local.begin() + std::ptrdiff_t((f + 1) * 33));
            tried.poses = {fitted.poses[f]};
            Vec3 by(0.0F);
            by[move % 3] = move % 2 == 0 ? 0.004F : -0.004F; // a radius
            if (move < 6)
                tried.poses[0].centre += by;
            else
                tried.poses[0].rotation = unit(Rotation(1, by * 2.0F) * tried.poses[0].rotation);
            if (cost(tried, 0) < 0.9 * least - 1e-5) {
                ++worse;
                break;
            }
        }
    }
    EXPECT_LE(worse, int(settings.count) / 50); // those that 35 steps do not bring to the end
}

/// The method of the thesis over all vertices of the target.
struct BruteForce {
    const NearestVertices& target;

    float depth(const Vec3& p) const {
        float least = std::numeric_limits<float>::max();
        float depth = 0;
        for (std::size_t v = 0; v < target.surface.size(); v += 6) {
            const float* s = &target.surface[v];
            const Vec3 way = p - Vec3(s[0], s[1], s[2]);
            if (way.length2() < least) {
                least = way.length2();
                depth = -way.dot(Vec3(s[3], s[4], s[5]));
            }
        }
        return depth;
    }

    std::vector<Vec3> placed(std::span<const Vec3> local, const Pose& pose) const {
        std::vector<Vec3> points;
        points.reserve(local.size());
        for (const Vec3& p : local)
            points.push_back(pose.centre + rotated(pose.rotation, p));
        return points;
    }

    /// The pose after one iteration.
    Pose iterated(std::span<const Vec3> local, const Pose& pose, float length) const {
        const std::vector<Vec3> points = placed(local, pose);
        std::vector<char> counted(points.size(), 0);
        for (std::size_t i = 0; i + 1 < points.size(); ++i)
            if (depth(points[i]) < 0 || depth(points[i + 1]) < 0)
                counted[i] = counted[i + 1] = 1;
        const auto cost = [&](const Pose& at) {
            const std::vector<Vec3> moved = placed(local, at);
            float sum = 0;
            for (std::size_t i = 0; i < moved.size(); ++i)
                sum += counted[i] != 0 ? depth(moved[i]) : 0;
            return sum;
        };
        Pose best = pose;
        for (int axis = 0; axis < 3; ++axis)
            for (const float sign : {1.0F, -1.0F}) {
                Pose shifted = pose;
                shifted.centre[axis] += sign * 0.02F * length;
                Pose turned = pose;
                Vec3 v(0.0F);
                v[axis] = sign * std::sin(float(radians(1)));
                turned.rotation = unit(Rotation(std::cos(float(radians(1))), v) * pose.rotation);
                for (const Pose& tried : {shifted, turned})
                    if (cost(tried) > cost(best))
                        best = tried;
            }
        return best;
    }
};

TEST_F(Adjustment, ThesisTakesTheBestMoveByBruteForce) {
    const NearestVertices vertices(*target, 0.4);
    placed.poses.resize(40);
    const std::vector<float> lengths(40, 0.8F);
    RigidFibres fitted = placed;
    const int iterations = adjust_thesis(fitted, vertices, lengths, {});
    EXPECT_GT(iterations, 5);
    const BruteForce brute{vertices};
    int same = 0;
    for (std::size_t f = 0; f < 40; ++f) {
        Pose pose = placed.poses[f];
        for (int i = 0; i < iterations; ++i)
            pose = brute.iterated({&placed.local[f * 33], 33}, pose, 0.8F);
        same += (pose.centre - fitted.poses[f].centre).length() < 1e-4F;
    }
    EXPECT_GE(same, 39); // two moves may be equally good but for rounding
}

TEST_F(Adjustment, IsTheSameOnADevice) {
    Device device;
    const NearestVertices vertices(*target, 0.4);
    const std::vector<float> lengths(settings.count, 0.8F);
    const auto difference = [&](const auto& adjust) {
        RigidFibres here = placed;
        RigidFibres there = placed;
        EXPECT_EQ(adjust(here, Context{}), adjust(there, Context{.device = &device}));
        std::size_t differ = 0;
        for (std::size_t f = 0; f < settings.count; ++f)
            differ += (here.poses[f].centre - there.poses[f].centre).length() > 1e-5F;
        return differ;
    };
    EXPECT_EQ(difference([&](RigidFibres& fibres, const Context& context) {
                  return adjust_nearest(fibres, grid, settings.shape.radius, context);
              }),
              0U);
    EXPECT_EQ(difference([&](RigidFibres& fibres, const Context& context) {
                  return adjust_thesis(fibres, vertices, lengths, context);
              }),
              0U);
}

} // namespace
} // namespace scree
