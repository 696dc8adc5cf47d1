// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/random.h"
#include "tests/support/rendering.h"

#include <gtest/gtest.h>

namespace scree {
namespace {

using test::random_direction;

// Möller & Trumbore 1997, in double; infinity for a miss.
double brute_force(const Vec3& a, const Vec3& b, const Vec3& c, const Ray& ray) {
    const Imath::V3d o(ray.origin);
    const Imath::V3d d(ray.direction);
    const Imath::V3d e1 = Imath::V3d(b) - Imath::V3d(a);
    const Imath::V3d e2 = Imath::V3d(c) - Imath::V3d(a);
    const Imath::V3d p = d.cross(e2);
    const double determinant = e1.dot(p);
    const Imath::V3d s = o - Imath::V3d(a);
    const double u = s.dot(p) / determinant;
    const Imath::V3d q = s.cross(e1);
    const double v = d.dot(q) / determinant;
    const double t = e2.dot(q) / determinant;
    return u >= 0 && v >= 0 && u + v <= 1 && t > 0 ? t : INFINITY;
}

Matrix skewed(Random& random) {
    Matrix m;
    const Vec3 axis = random_direction(random);
    m.setAxisAngle(axis, static_cast<float>(random.uniform(0, 6)));
    Matrix scale;
    const double mirror = random.uniform() < 0.5 ? -1 : 1;
    scale.setScale(Vec3(static_cast<float>(mirror * random.uniform(0.5, 2)),
                        static_cast<float>(random.uniform(0.5, 2)), 1.0F));
    return scale * m *
           test::move(Vec3(static_cast<float>(random.uniform(-3, 3)),
                           static_cast<float>(random.uniform(-3, 3)),
                           static_cast<float>(random.uniform(-3, 3))));
}

// From how many instances on they are kept together: never, and always.
class WorldOfBoth : public testing::TestWithParam<std::size_t> {};
INSTANTIATE_TEST_SUITE_P(Instances, WorldOfBoth,
                         testing::Values(std::numeric_limits<std::size_t>::max(), 0));

TEST_P(WorldOfBoth, AgreesWithBruteForce) {
    Random random(21, Purpose::test);
    const Mesh mesh = test::make_sphere(0.5F, 8);
    Aggregate aggregate;
    aggregate.prototypes.push_back({"sphere",
                                    std::make_shared<Mesh>(mesh),
                                    nullptr,
                                    {std::make_shared<const Material>(Metal{})}});
    for (int i = 0; i < 20; ++i)
        aggregate.instances.push_back({0, WideMatrix(skewed(random)), 0.0F, 0.0F, 1.0F});
    const World world(std::span(&aggregate, 1), {}, {}, WideVec3(0),
                      {.many_instances = GetParam()});
    EXPECT_EQ(world.instance_count(), 20U);
    EXPECT_EQ(world.triangle_count(), 20 * mesh.triangles.size());
    EXPECT_EQ(world.materials().size(), 2U);
    EXPECT_GT(world.memory_bytes(), 1000U);
    int disagreements = 0;
    int hits = 0;
    for (int i = 0; i < 4000; ++i) {
        const Vec3 origin = random_direction(random) * 8;
        const Ray ray{origin, (random_direction(random) * 3 - origin).normalized()};
        double nearest = INFINITY;
        std::size_t instance = 0;
        Vec3 normal(0.0F, 0.0F, 0.0F);
        for (std::size_t k = 0; k < aggregate.instances.size(); ++k) {
            const WideMatrix& m = aggregate.instances[k].world_from_object;
            for (const Mesh::Triangle& t : mesh.triangles) {
                const Vec3 a = transform_point(m, mesh.positions[t[0]]);
                const Vec3 b = transform_point(m, mesh.positions[t[1]]);
                const Vec3 c = transform_point(m, mesh.positions[t[2]]);
                const double distance = brute_force(a, b, c, ray);
                if (distance < nearest) {
                    nearest = distance;
                    instance = k;
                    normal = (b - a).cross(c - a).normalized();
                    if (m.determinant() < 0)
                        normal = -normal;
                }
            }
        }
        Hit hit;
        const bool found = world.hit(ray, hit);
        EXPECT_EQ(world.occluded(ray), found);
        if (found != std::isfinite(nearest)) {
            ++disagreements; // rays along an edge may go either way
            continue;
        }
        if (!found)
            continue;
        ++hits;
        ASSERT_NEAR(hit.distance, nearest, 1e-4);
        ASSERT_EQ(hit.instance, instance);
        ASSERT_GT(hit.normal.dot(normal), 0.999F);
        ASSERT_LT(hit.normal.dot(ray.direction), 0) << "outwards also when mirrored";
        ASSERT_GT(hit.shading_normal.dot(hit.normal), 0.7F);
        ASSERT_LT((ray.origin + ray.direction * hit.distance - hit.position).length(), 1e-4F);
        ASSERT_EQ(hit.material, 1U);
        Ray shorter = ray;
        shorter.length = hit.distance * 0.999F;
        ASSERT_FALSE(world.occluded(shorter));
    }
    EXPECT_LE(disagreements, 2);
    EXPECT_GT(hits, 500);
}

TEST_P(WorldOfBoth, RaysThatLeaveDoNotMeetTheirSurface) {
    // A convex body is never met again by a ray that leaves it, at any place and size.
    for (const float scale : {1e-4F, 1.0F, 100.0F})
        for (const float distance : {0.0F, 3.0F, 300.0F}) {
            Random random(22, Purpose::test);
            Matrix m;
            m.setAxisAngle(Vec3(1.0F, 2.0F, 3.0F).normalized(), 1.0F);
            Matrix s;
            s.setScale(scale);
            test::Stage stage;
            stage.add(test::make_sphere(1, 24, false), test::grey_matte(1),
                      s * m * test::move(Vec3(distance, distance * 0.5F, -distance)));
            const World world(stage.aggregates, {}, {}, WideVec3(0),
                              {.many_instances = GetParam()});
            const Vec3 centre(distance, distance * 0.5F, -distance);
            int met = 0;
            for (int i = 0; i < 20000; ++i) {
                const Vec3 from = centre + random_direction(random) * (3 * scale);
                Hit hit;
                const Vec3 target = centre + random_direction(random) * (0.5F * scale);
                if (!world.hit({from, (target - from).normalized()}, hit))
                    continue;
                Vec3 d = random_direction(random);
                if (d.dot(hit.normal) < 0)
                    d = -d;
                met += world.occluded(hit.leave(d)) ? 1 : 0;
            }
            EXPECT_EQ(met, 0) << scale << " at " << distance;
        }
}

TEST(World, EmptyWorldAndLightsOnly) {
    const World empty({}, {});
    Hit hit;
    EXPECT_FALSE(empty.hit({Vec3(0.0F, 0.0F, 0.0F), Vec3(0.0F, 1.0F, 0.0F)}, hit));
    EXPECT_TRUE(empty.bounds().isEmpty());
    std::vector<Light> lights = {Sun{}, AreaLight{}};
    std::get<AreaLight>(lights[1]).centre = {0.0F, 2.0F, 0.0F};
    const World world({}, lights);
    ASSERT_TRUE(world.hit({Vec3(0.2F, 0.0F, 0.1F), Vec3(0.0F, 1.0F, 0.0F)}, hit));
    EXPECT_EQ(hit.light, 1U);
    EXPECT_FLOAT_EQ(hit.distance, 2);
    EXPECT_LT(hit.normal.y, -0.999F);
}

// The hit in the middle of a triangle of one square metre that faces up, seen from above.
Hit hit_on_triangle(const std::vector<Vec2f>& uvs, const Material& material,
                    const Matrix& matrix = {}) {
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {0, 0, 2}, {0.5F, 0, 0}};
    mesh.uvs = uvs;
    mesh.triangles = {{0, 1, 2}};
    test::Stage stage;
    stage.add(mesh, material, matrix);
    const World world(stage.aggregates, {});
    const Vec3 middle = transform_point(matrix, Vec3(0.125F, 0, 0.5F));
    Hit hit;
    EXPECT_TRUE(world.hit({middle + Vec3(0, 5, 0), Vec3(0, -1, 0)}, hit));
    return hit;
}

// Depends on the UVs, as a picture does.
class Flat final : public Procedural {
  public:
    void evaluate(std::span<const ShadingPoint>, std::span<ShadingSample>) const override {}
};

TEST(World, HitsCarryUvAndTangentWhereTheMaterialUsesThem) {
    const std::vector<Vec2f> uvs = {{0, 0}, {0, 3}, {3, 0}}; // u along x, v along z
    const Material textured = Matte{{{Color(0.0F), std::make_shared<Flat>()}, {}}};
    Matrix turned;
    turned.setAxisAngle(Vec3(0, 1, 0), 0.5F);
    const Hit hit = hit_on_triangle(uvs, textured, turned * test::move({1, 2, 3}));
    EXPECT_LT((hit.uv - Vec2f(0.75F, 0.75F)).length(), 1e-5F);
    EXPECT_FLOAT_EQ(hit.uv_per_metre, 3.0F);
    EXPECT_LT((hit.tangent - Vec3(std::cos(0.5F), 0, -std::sin(0.5F))).length(), 1e-5F);

    // Mirrored UVs, and a mirrored object.
    EXPECT_LT(
        (hit_on_triangle({{0, 0}, {0, 3}, {-3, 0}}, textured).tangent - Vec3(-1, 0, 0)).length(),
        1e-5F);
    Matrix mirror;
    mirror.setScale(Vec3(1, 1, -1));
    EXPECT_LT((hit_on_triangle({{0, 0}, {1, 0}, {0, 1}}, textured, mirror).tangent - Vec3(0, 0, -1))
                  .length(),
              1e-5F);

    // Without UVs, or where they are all the same, any direction along the surface.
    for (const std::vector<Vec2f>& none :
         {std::vector<Vec2f>{}, std::vector<Vec2f>(3, Vec2f(0.0F))}) {
        const Hit bare = hit_on_triangle(none, textured);
        EXPECT_EQ(bare.uv, Vec2f(0.0F));
        EXPECT_EQ(bare.uv_per_metre, 0);
        EXPECT_NEAR(bare.tangent.length(), 1, 1e-5F);
        EXPECT_NEAR(bare.tangent.dot(bare.normal), 0, 1e-5F);
    }
    EXPECT_EQ(hit_on_triangle(uvs, test::grey_matte(1)).uv, Vec2f(0.0F));
}

TEST(World, BuildsCanBeCancelled) {
    test::Stage stage;
    stage.add(test::make_sphere(1, 64), test::grey_matte(1));
    Cancel cancel;
    cancel.request();
    Context context;
    context.cancel = &cancel;
    EXPECT_THROW(World(stage.aggregates, {}, context), Cancelled);
}

} // namespace
} // namespace scree
