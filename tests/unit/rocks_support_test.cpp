// SPDX-License-Identifier: GPL-3.0-or-later
// Dropped rocks by the check of support that piles use, which knows nothing of how they fell.
#include "generators/rocks/drop.h"
#include "generators/rocks/rock_sizes.h"
#include "geometry/bodies/support.h"
#include "tests/support/piles.h"
#include "tests/support/regions.h"

#include <gtest/gtest.h>

namespace scree::rocks {
namespace {

/// A body of half the longest axis `scale` [m].
std::shared_ptr<const Body> body_of(const RockSurface& surface, double scale) {
    Mesh mesh;
    for (const Vec3& v : surface.vertices)
        mesh.positions.push_back(v * float(scale));
    mesh.triangles = surface.triangles;
    return tests::body_of(std::move(mesh));
}

TEST(RocksSupport, NoRockFallsByTheChecksOfPiles) {
    std::vector<RockSurface> surfaces;
    for (std::uint64_t i = 0; i < 6; ++i)
        surfaces.push_back(make_rock_surface({.seed = i}, 4, "rock"));
    const Ground ground(0);
    const auto domain = tests::shared_square(1.6);
    const std::vector<double> sizes = power_sizes(0.1, 0.4, 2, 150, 1);
    const std::vector<PlacedRock> rocks = drop_rocks(
        {.ground = ground,
         .domain = *domain,
         .surfaces = surfaces,
         .sizes = sizes,
         .surface_of = [&](std::size_t,
                           std::uint32_t kind) { return kind % std::uint32_t(surfaces.size()); },
         .likely = {},
         .rest = {.burial = 0},
         .seed = 3},
        {});
    // Each rock is a body of its own, since bodies have no scale.
    Bodies bodies;
    std::vector<PlacedBody> placed;
    for (const PlacedRock& rock : rocks) {
        if (!rock.placed)
            continue;
        bodies.push_back(body_of(surfaces[rock.surface], rock.scale));
        const Imath::M33f turn(rock.world_from_rock);
        placed.push_back({.body = std::uint32_t(placed.size()),
                          .pose = {rock.centre + WideVec3(bodies.back()->origin * turn), turn}});
    }
    PlacedBodies all(bodies);
    for (const PlacedBody& body : placed)
        all.add(body);
    ASSERT_GT(placed.size(), 120U);
    const ContactGraph graph = contact_graph(all, {.floor = 0.0});
    const Support support = support_of(graph);
    const auto share = [&](const std::vector<char>& flags) {
        return double(std::count(flags.begin(), flags.end(), char(1))) / double(flags.size());
    };
    EXPECT_EQ(share(support.floating), 0);
    // Rocks may also be wedged, by friction on walls that stand beside their centre of mass.
    EXPECT_LE(share(support.unsupported), 0.02);
}

} // namespace
} // namespace scree::rocks
