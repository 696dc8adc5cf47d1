// SPDX-License-Identifier: GPL-3.0-or-later
// The two ways in which a world keeps its instances: one of Embree's each, or all as one geometry.
#include "core/parallel.h"
#include "tests/support/strands.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

namespace scree {
namespace {

using test::random_direction;

constexpr std::size_t each = std::numeric_limits<std::size_t>::max();
constexpr std::size_t together = 0;

World world_of(const std::vector<Aggregate>& aggregates, std::size_t way,
               const std::vector<Light>& lights = {}, const WideVec3& origin = WideVec3(0),
               std::size_t most_chords = WorldLimits{}.most_chords) {
    return World(aggregates, lights, {}, origin,
                 {.many_instances = way, .most_chords = most_chords});
}

// Turned, stretched, sheared, in one case of two mirrored, and moved.
WideMatrix any_place(Random& random, double spread) {
    WideMatrix stretch;
    WideMatrix shear;
    WideMatrix turn;
    WideMatrix move;
    const double mirror = random.uniform() < 0.5 ? -1 : 1;
    stretch.setScale(WideVec3(mirror * random.uniform(0.3, 2), random.uniform(0.3, 2), 1));
    shear.setShear(WideVec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)));
    turn.setAxisAngle(WideVec3(random_direction(random)), random.uniform(0, 6));
    move.setTranslation(WideVec3(random_direction(random)) * (spread * random.uniform()));
    return stretch * shear * turn * move;
}

Prototype prototype_of(const Shape& shape, const Material& material) {
    return {
        .name = "shape", .shape = shape, .materials = {std::make_shared<const Material>(material)}};
}

// Meshes, one of them flat, chains, splines with caps, fibres, nothing, and instances of no size.
std::vector<Aggregate> mixed_scene(int count) {
    Random random(51, Purpose::test);
    const auto chains =
        std::make_shared<const Strands>(test::random_chains(random, 5, 6, 0.1F, 0.03F, 0.5F));
    const auto splines = std::make_shared<const Strands>(
        test::random_chains(random, 5, 6, 0.1F, 0.03F, 0.5F, CurveKind::bspline));
    Aggregate solids;
    solids.generator = "solids";
    solids.prototypes = {
        {.name = "nothing"},
        prototype_of(std::make_shared<const Mesh>(test::make_sphere(0.3F, 8)),
                     test::grey_matte(0.5F)),
        prototype_of(std::make_shared<const Mesh>(test::make_plane(0.5F)), test::grey_matte(0.9F))};
    Aggregate hairs;
    hairs.generator = "hairs";
    hairs.prototypes = {prototype_of(chains, test::grey_matte(0.5F)),
                        prototype_of(splines, test::grey_matte(0.5F)),
                        prototype_of(splines, Fibre{})};
    for (int i = 0; i < count; ++i)
        for (Aggregate* aggregate : {&solids, &hairs}) {
            WideMatrix place = any_place(random, 3);
            if (i % 10 == 0)
                place = WideMatrix(0.0) * place;
            aggregate->instances.push_back(
                {.prototype = static_cast<std::uint32_t>(i % 3), .world_from_object = place});
        }
    return {solids, hairs};
}

bool same_surface(const RawHit& a, const RawHit& b) {
    return a.geometry == b.geometry && a.instance == b.instance && a.primitive == b.primitive;
}

TEST(Instances, BothWaysMeetTheSame) {
    std::vector<Light> lights(1, AreaLight{});
    std::get<AreaLight>(lights[0]).centre = {0, 3, 0};
    const std::vector<Aggregate> aggregates = mixed_scene(200);
    const std::size_t cones = WorldLimits{}.most_chords;
    // How far the world's origin and then the rays are off, and what the splines are.
    for (const auto& [far, chords] :
         {std::pair(0.0, std::size_t{0}), {1000.0, 0}, {0.0, cones}, {1000.0, cones}}) {
        const World one = world_of(aggregates, each, lights, WideVec3(far, 0, 0), chords);
        const World other = world_of(aggregates, together, lights, WideVec3(far, 0, 0), chords);
        EXPECT_EQ(one.instance_count(), other.instance_count());
        EXPECT_EQ(one.triangle_count(), other.triangle_count());
        EXPECT_EQ(one.strand_figures().segments, other.strand_figures().segments);
        Random random(52, Purpose::test);
        const Vec3 centre(float(-far), 0, 0);
        int unlike = 0;
        int lit = 0;
        std::set<std::uint32_t> instances;
        for (int i = 0; i < 20000; ++i) {
            const Vec3 from = random_direction(random) * (6 * random.uniform_float());
            const Vec3 to = random_direction(random) * (3 * random.uniform_float());
            Ray ray{centre + from, (to - from).normalized()};
            const RawHit a = one.find(ray);
            const RawHit b = other.find(ray);
            ray.length = 3 * random.uniform_float();
            unlike += one.occluded(ray) != other.occluded(ray);
            // Along edges, and where two surfaces meet, rounding may go either way.
            if (!same_surface(a, b)) {
                ++unlike;
                continue;
            }
            if (!a.found())
                continue;
            ASSERT_NEAR(a.distance, b.distance, far > 0 ? 1e-2 : 1e-4);
            if (a.instance == Hit::none)
                ++lit;
            else
                instances.insert(a.instance);
            Hit hit;
            other.fill(ray, b, hit);
            // The ends of fibres, balls in Embree's tree, are taken to their tubes.
            const bool ball = chords > 0 && hit.tangent != Vec3(0.0F);
            const float allowed = ball ? 0.1F : far > 0 ? 1e-2F : 5e-3F;
            ASSERT_LT((hit.position - ray.origin - ray.direction * b.distance).length(), allowed);
        }
        EXPECT_LE(unlike, far > 0 ? 200 : 10);
        EXPECT_GT(lit, 10);
        EXPECT_GT(instances.size(), 200U);
    }
}

TEST(Instances, BothWaysGiveTheSamePicture) {
    const std::vector<Aggregate> aggregates = mixed_scene(60);
    const std::vector<Light> lights{test::even_sky(1), Sun{}};
    Camera camera;
    camera.from = {0, 2, 7};
    camera.at = {0, 0, 0};
    FilmSettings film;
    film.width = film.height = 48;
    film.samples = 16;
    film.depth = 4;
    const auto picture = [&](std::size_t way) {
        return render(world_of(aggregates, way, lights), camera, film, {}).film.beauty();
    };
    const Image one = picture(each);
    const Image other = picture(together);
    double sum = 0;
    double difference = 0;
    for (std::size_t i = 0; i < one.pixels.size(); ++i) {
        sum += one.pixels[i];
        difference += std::abs(one.pixels[i] - other.pixels[i]);
    }
    // The paths begin with the same random numbers: few part ways.
    EXPECT_LT(difference, 0.005 * sum);
}

// A bed of small spheres.
std::vector<Aggregate> many_spheres(std::size_t count) {
    Aggregate aggregate;
    aggregate.generator = "spheres";
    aggregate.prototypes = {prototype_of(std::make_shared<const Mesh>(test::make_sphere(0.05F, 4)),
                                         test::grey_matte(0.5F))};
    Random random(53, Purpose::test);
    for (std::size_t i = 0; i < count; ++i) {
        WideMatrix place;
        place.setTranslation(
            WideVec3(random.uniform(-9, 9), random.uniform(0, 0.5), random.uniform(-9, 9)));
        aggregate.instances.push_back({.prototype = 0, .world_from_object = place});
    }
    return {aggregate};
}

TEST(Instances, ManyTakeLittleMemory) {
    const std::size_t count = 100'000;
    const std::vector<Aggregate> aggregates = many_spheres(count);
    const World world(aggregates, {});
    EXPECT_LT(world.memory_bytes() / count, 160U);
    EXPECT_LT(world.peak_bytes() / count, 250U);
    EXPECT_GT(world_of(aggregates, each).memory_bytes(), 2 * world.memory_bytes());
}

TEST(Instances, AreTheSameForAnyThreads) {
    const std::vector<Aggregate> aggregates = many_spheres(50'000);
    std::vector<RawHit> hits[2];
    for (const int threads : {1, 2}) {
        const ThreadLimit limit(threads);
        const World world = world_of(aggregates, together);
        Random random(54, Purpose::test);
        for (int i = 0; i < 20'000; ++i) {
            const Vec3 from = random_direction(random) * 9;
            hits[threads - 1].push_back(world.find({from, random_direction(random)}));
        }
    }
    for (std::size_t i = 0; i < hits[0].size(); ++i) {
        ASSERT_TRUE(same_surface(hits[0][i], hits[1][i]));
        ASSERT_EQ(hits[0][i].distance, hits[1][i].distance);
        ASSERT_EQ(hits[0][i].barycentric, hits[1][i].barycentric);
    }
}

TEST(Instances, BuildsOfManyCanBeCancelled) {
    Cancel cancel;
    cancel.request();
    Context context;
    context.cancel = &cancel;
    EXPECT_THROW(World(mixed_scene(10), {}, context, WideVec3(0), {.many_instances = together}),
                 Cancelled);
}

} // namespace
} // namespace scree
