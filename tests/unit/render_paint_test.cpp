// SPDX-License-Identifier: GPL-3.0-or-later
// Where procedurals are evaluated and what becomes of their answers, under every kind of transform.
#include "core/random.h"
#include "render/bsdf/ggx.h"
#include "render/paint.h"
#include "render/surface.h"
#include "render/world/instance_record.h"
#include "tests/support/rendering.h"

#include <gtest/gtest.h>

#include <mutex>

namespace scree {
namespace {

using test::random_direction;

using DVec3 = Imath::V3d;
using DMatrix = Imath::M44d;

DVec3 wide(const Vec3& v) { return {double(v.x), double(v.y), double(v.z)}; }
Vec3 narrow(const DVec3& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

Matrix transform(const Vec3& scale, const Vec3& axis, float angle) {
    Matrix turn;
    turn.setAxisAngle(axis.normalized(), angle);
    Matrix size;
    size.setScale(scale);
    return size * turn * test::move(Vec3(0.3F, -0.2F, 5.0F));
}

// Plain, scaled and turned, mirrored, squeezed, and sheared.
std::vector<Matrix> transforms() {
    const Vec3 axis(1.0F, 2.0F, -0.5F);
    const Matrix squeezed = transform({0.5F, 2.0F, 1.2F}, axis, 0.8F);
    return {Matrix(), transform({3.0F, 3.0F, 3.0F}, axis, 2.0F),
            transform({-0.1F, 0.1F, 0.1F}, axis, 1.0F), squeezed,
            squeezed * transform({1.0F, -1.5F, 0.7F}, Vec3(0.0F, 1.0F, 1.0F), 1.3F)};
}

DMatrix wide(const Matrix& m) {
    DMatrix result;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            result[i][j] = double(m[i][j]);
    return result;
}

DVec3 direction(const DMatrix& m, const DVec3& v) {
    DVec3 result;
    m.multDirMatrix(v, result);
    return result;
}

/// By what factors a matrix stretches the object's axes.
DVec3 stretch_of(const Matrix& matrix) {
    const DMatrix m = wide(matrix);
    DVec3 out;
    for (int axis = 0; axis < 3; ++axis)
        out[axis] = DVec3(m[axis][0], m[axis][1], m[axis][2]).length();
    return out;
}

// A hit on the unit sphere of an object at its point `p`.
struct Placed {
    Placed(const Matrix& matrix, const DVec3& p) : inverse(wide(matrix).inverse()) {
        Instance instance;
        instance.world_from_object = WideMatrix(matrix);
        instance.random = 0.625F;
        record = instance_record(instance, 0, WideVec3(0));
        hit.record = &record;
        hit.random = record.random;
        hit.object_position = narrow(p);
        hit.position = record.point(hit.object_position);
        hit.normal = hit.shading_normal = narrow(direction(inverse.transposed(), p).normalized());
    }
    DMatrix inverse;
    InstanceRecord record{};
    Hit hit;
};

// Second moments of the filter.
double moment(const DVec3& a, const DVec3& b, int i, int j) { return a[i] * a[j] + b[i] * b[j]; }

TEST(Paint, FilterLiesOnTheSurfaceInTheObjectsFrame) {
    Random random(31, Purpose::test);
    for (const Matrix& matrix : transforms())
        for (int trial = 0; trial < 100; ++trial) {
            const Placed placed(matrix, wide(random_direction(random)));
            // Every tenth from straight above, every tenth along the surface.
            Vec3 ray = random_direction(random);
            if (trial % 10 == 0)
                ray = -placed.hit.normal;
            if (trial % 10 == 1)
                ray = ray.cross(placed.hit.normal).normalized();
            const float width = 0.01F;
            const bool in_metres = trial % 2 == 0;
            const ShadingPoint point = shading_point(
                placed.hit, ray, width, in_metres ? TextureUnit::world : TextureUnit::object);
            const DVec3 stretch = in_metres ? stretch_of(matrix) : DVec3(1.0);
            for (int axis = 0; axis < 3; ++axis)
                ASSERT_NEAR(double(point.position[axis]),
                            double(placed.hit.object_position[axis]) * stretch[axis],
                            1e-5 * stretch[axis]);
            const DVec3 across = wide(point.across);
            const DVec3 along = wide(point.along);
            ASSERT_LE(across.length(), along.length() * (1 + 1e-5));
            ASSERT_NEAR(across.dot(along), 0, 3e-5 * across.length() * along.length());
            ASSERT_NEAR(double(point.footprint) / across.length(), 1, 1e-5);
            ASSERT_EQ(point.random, 0.625F);

            // The square that faces the ray, projected along it onto the surface, in the world.
            const DVec3 n = wide(placed.hit.normal);
            const DVec3 d = wide(ray);
            DVec3 level = n.cross(d);
            level = level.length() > 1e-4 ? level.normalized() : n.cross(wide(point.across));
            level.normalize();
            const double cosine = std::max(1.0 / 64, std::abs(n.dot(d)));
            const DVec3 a = direction(placed.inverse, level * double(width)) * stretch;
            const DVec3 b =
                direction(placed.inverse, level.cross(n).normalized() * (double(width) / cosine)) *
                stretch;
            if (trial % 10 == 0 && !placed.record.similar)
                continue; // any pair of directions is as good, so there is nothing to compare with
            const double size = b.dot(b) + a.dot(a);
            for (int i = 0; i < 3; ++i)
                for (int j = i; j < 3; ++j)
                    ASSERT_NEAR(moment(across, along, i, j), moment(a, b, i, j), 2e-4 * size);
        }
}

// Bumps so small and steep that the curvature of the sphere does not matter.
constexpr double amplitude = 1e-5;
double height(const DVec3& p) {
    return amplitude * (std::sin(30000 * p.x) + std::cos(40000 * p.y) * std::sin(20000 * p.z));
}
DVec3 slope(const DVec3& p) {
    return DVec3(30000 * std::cos(30000 * p.x),
                 -40000 * std::sin(40000 * p.y) * std::sin(20000 * p.z),
                 20000 * std::cos(40000 * p.y) * std::cos(20000 * p.z)) *
           amplitude;
}

TEST(Paint, BentNormalIsThatOfTheRaisedSurface) {
    Random random(32, Purpose::test);
    double most = 0;
    for (const Matrix& matrix : transforms())
        for (int trial = 0; trial < 200; ++trial) {
            const DVec3 p = wide(random_direction(random)).normalized();
            const Placed placed(matrix, p);
            // Differences of the raised surface, taken to the world.
            const DVec3 u = p.cross(std::abs(p.x) < 0.5 ? DVec3(1, 0, 0) : DVec3(0, 1, 0));
            const DMatrix world = wide(matrix);
            const auto raised = [&](const DVec3& offset) {
                const DVec3 q = (p + offset).normalized();
                DVec3 result;
                world.multVecMatrix(q * (1 + height(q)), result);
                return result;
            };
            constexpr double step = 1e-8;
            const DVec3 x = u.normalized() * step;
            const DVec3 y = p.cross(u).normalized() * step;
            DVec3 expected = (raised(x) - raised(-x)).cross(raised(y) - raised(-y)).normalized();
            if (expected.dot(wide(placed.hit.normal)) < 0)
                expected = -expected;
            const DVec3 found =
                wide(bent_normal(placed.hit, narrow(slope(p)), TextureUnit::object));
            ASSERT_LT((found - expected).length(), 2e-4);
            most = std::max(most, (found - wide(placed.hit.normal)).length());
        }
    EXPECT_GT(most, 0.3) << "too flat to tell anything";
}

// As above, but the height is in metres of the world, above a place given in them.
TEST(Paint, BentNormalInMetresIsThatOfTheRaisedSurface) {
    Random random(33, Purpose::test);
    double most = 0;
    for (const Matrix& matrix : transforms())
        for (int trial = 0; trial < 200; ++trial) {
            const DVec3 p = wide(random_direction(random)).normalized();
            const Placed placed(matrix, p);
            const DVec3 stretch = stretch_of(matrix);
            const DVec3 u = p.cross(std::abs(p.x) < 0.5 ? DVec3(1, 0, 0) : DVec3(0, 1, 0));
            const DMatrix world = wide(matrix);
            const DVec3 n = wide(placed.hit.normal);
            const auto raised = [&](const DVec3& offset) { // the plane that touches the sphere
                DVec3 moved;
                world.multDirMatrix(offset, moved);
                return moved + n * height((p + offset) * stretch);
            };
            constexpr double step = 1e-8;
            const DVec3 x = u.normalized() * step;
            const DVec3 y = p.cross(u).normalized() * step;
            DVec3 expected = (raised(x) - raised(-x)).cross(raised(y) - raised(-y)).normalized();
            if (expected.dot(n) < 0)
                expected = -expected;
            const DVec3 found =
                wide(bent_normal(placed.hit, narrow(slope(p * stretch)), TextureUnit::world));
            ASSERT_LT((found - expected).length(), 5e-4);
            most = std::max(most, (found - n).length());
        }
    EXPECT_GT(most, 0.3) << "too flat to tell anything";
}

// Records what it was asked.
class Probe final : public Procedural {
  public:
    explicit Probe(const ShadingSample& answer) : answer_(answer) {}
    void evaluate(std::span<const ShadingPoint> points,
                  std::span<ShadingSample> samples) const override {
        const std::lock_guard lock(mutex_);
        batches.push_back(points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            asked.push_back(points[i]);
            samples[i] = answer_;
        }
    }
    mutable std::vector<ShadingPoint> asked;
    mutable std::vector<std::size_t> batches; // how many points were asked at once

  private:
    ShadingSample answer_;
    mutable std::mutex mutex_;
};

Surface seen(const MaterialSet& materials, const Hit& hit, const Vec3& direction) {
    const PaintQuery query{&materials.at(hit).paint(), &hit, direction, 0.01F};
    Painted painted;
    paint({&query, 1}, {&painted, 1});
    return materials.surface(hit, direction, painted);
}

TEST(Paint, AsksEachProceduralOnceAboutAllItsHits) {
    ShadingSample red, blue;
    red.color = {1.0F, 0.0F, 0.0F};
    red.slope = {0.5F, 0.0F, 0.0F};
    blue.color = {0.0F, 0.0F, 1.0F};
    const auto one = std::make_shared<Probe>(red), other = std::make_shared<Probe>(blue);
    const Paint paints[] = {{{Color(0.0F), one}, {}},
                            {{Color(0.0F), other}, {}},
                            {{Color(0.5F), nullptr}, {}},
                            {{Color(0.0F), one}, {Color(0.25F)}}};
    const Placed placed(Matrix(), DVec3(0.3, 0.5, 0.1));
    std::vector<Hit> hits(most_painted, placed.hit);
    std::vector<PaintQuery> queries;
    for (std::size_t i = 0; i < most_painted; ++i) {
        hits[i].object_position = Vec3(float(i), 0.0F, 0.0F);
        queries.push_back({&paints[i % 4], &hits[i], Vec3(0.0F, -1.0F, 0.0F), 0.01F});
    }
    std::vector<Painted> painted(most_painted);
    painted[2].bent = true; // from before
    paint(queries, painted);
    EXPECT_EQ(one->batches, std::vector<std::size_t>{most_painted / 4});
    EXPECT_EQ(other->batches, std::vector<std::size_t>{most_painted / 4});
    const Color colors[] = {red.color, blue.color, Color(0.5F), Color(0.25F)};
    for (std::size_t i = 0; i < most_painted; ++i) {
        EXPECT_EQ(painted[i].color, colors[i % 4]) << i;
        EXPECT_EQ(painted[i].bent, i % 4 == 0) << i;
    }
    for (std::size_t i = 0; i < one->asked.size(); ++i)
        EXPECT_EQ(one->asked[i].position.x, float(4 * i));
}

TEST(Paint, OneQuestionPerHitAnswersAll) {
    ShadingSample answer;
    answer.color = {0.2F, 3.0F, -1.0F};
    answer.slope = {0.5F, 0.0F, 0.0F};
    answer.roughness = 0.5F;
    const auto probe = std::make_shared<Probe>(answer);
    const Paint paint{{Color(0.0F), probe}, {}};
    test::Stage stage;
    stage.add(test::make_plane(2), Matte{paint});
    const World world(stage.aggregates, {});
    Hit hit;
    const Vec3 down(0.0F, -1.0F, 0.0F);
    ASSERT_TRUE(world.hit({Vec3(0.1F, 1.0F, 0.2F), down}, hit));
    const MaterialSet materials =
        test::material_set({Matte{paint}, Plastic{paint, 0.1F, 1.5F}, Metal{paint, 0.1F}});
    for (hit.material = 0; hit.material < 3; ++hit.material) {
        const Surface surface = seen(materials, hit, down);
        EXPECT_EQ(probe->asked.size(), hit.material + 1);
        EXPECT_EQ(surface.bsdf.color, Color(0.2F, 1.0F, 0.0F));
        EXPECT_EQ(surface.bsdf.alpha, hit.material == 0 ? 0.0F : 0.25F);
        EXPECT_TRUE(surface.smooth);
        const Vec3 expected = Vec3(-0.5F, 1.0F, 0.0F).normalized();
        EXPECT_LT((surface.frame.z - expected).length(), 1e-5F) << hit.material;
    }
    // A procedural that gives neither slope nor roughness changes neither.
    const Paint plain{{Color(0.0F), std::make_shared<Probe>(ShadingSample{})}, {}};
    const MaterialSet metal = test::material_set({Metal{plain, 0.1F}});
    hit.material = 0;
    const Surface surface = seen(metal, hit, down);
    EXPECT_EQ(surface.bsdf.alpha, 0.1F * 0.1F);
    EXPECT_EQ(surface.frame.z, hit.normal);
    EXPECT_FALSE(surface.smooth);
}

float footprint_of(int samples, double time_limit, double noise) {
    const auto probe = std::make_shared<Probe>(ShadingSample{});
    test::Stage stage;
    stage.film.width = stage.film.height = 2;
    stage.film.depth = 2;
    stage.camera.from = {0.0F, 1.0F, 0.0F};
    stage.camera.up = {0.0F, 0.0F, 1.0F};
    stage.camera.fov = 0.002F;
    stage.add(test::make_plane(2), Matte{{{Color(0.0F), probe}, {}}});
    RenderOptions options;
    options.samples = samples;
    options.time_limit = time_limit;
    options.noise = noise;
    stage.render(options);
    return probe->asked.front().footprint / 0.001F; // in pixels
}

TEST(Paint, SamplesShareThePixelsWidth) {
    EXPECT_NEAR(footprint_of(1, 0, 0), 1, 1e-4);
    EXPECT_NEAR(footprint_of(4, 0, 0), 0.5, 1e-4);
    EXPECT_NEAR(footprint_of(36, 0, 0), 1 / 6.0, 1e-4);
    EXPECT_NEAR(footprint_of(256, 0, 0), 0.125, 1e-4);
    EXPECT_NEAR(footprint_of(256, 100, 0), 0.25, 1e-4);
    EXPECT_NEAR(footprint_of(256, 0, 0.01), 0.25, 1e-4);
    EXPECT_NEAR(footprint_of(4, 100, 0), 0.5, 1e-4);
}

} // namespace
} // namespace scree
