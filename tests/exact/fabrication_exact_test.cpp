// SPDX-License-Identifier: GPL-3.0-or-later
// The union of solids is closed, manifold, oriented and free of self-intersections, by CGAL's
// predicates.
#include "core/random.h"
#include "fabrication/cell_surface.h"
#include "fabrication/fabricate.h"
#include "tests/exact/cgal_surface.h"
#include "tests/support/fabrication_parts.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

#include <gtest/gtest.h>

namespace scree {
namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using tests::aggregate_of;
using tests::cgal_surface;
using tests::instance;
using tests::placed;
using tests::Point;
using tests::Surface;

std::size_t component_count(const Surface& surface) {
    std::map<Surface::Face_index, std::size_t> of_face;
    return PMP::connected_components(surface, boost::make_assoc_property_map(of_face));
}

void expect_solid(const Fabrication& made, std::size_t shells) {
    Surface surface = cgal_surface(made.mesh);
    EXPECT_EQ(surface.number_of_faces(), made.mesh.triangles.size());
    EXPECT_TRUE(CGAL::is_closed(surface));
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(surface));
    EXPECT_TRUE(PMP::does_bound_a_volume(surface));
    EXPECT_FALSE(PMP::does_self_intersect(surface));
    EXPECT_EQ(component_count(surface), shells);
    double volume = 0;
    for (const FabricationPart& part : made.parts)
        volume += part.volume;
    const auto measured = static_cast<double>(PMP::volume(surface));
    EXPECT_NEAR(measured, volume, 1e-5 * volume);
    EXPECT_GT(volume, 0);
}

float uniform(Random& random, float low, float high) {
    return low + (high - low) * random.uniform_float();
}

// Overlapping rings, boxes and balls in random orientations.
Aggregate heap(int count) {
    Random random(5, Purpose::test, 0);
    std::vector<Instance> instances;
    for (int i = 0; i < count; ++i) {
        const Vec3 at(uniform(random, -0.03F, 0.03F), uniform(random, -0.03F, 0.03F),
                      uniform(random, -0.03F, 0.03F));
        const Vec3 turn(uniform(random, 0, 6), uniform(random, 0, 6), uniform(random, 0, 6));
        instances.push_back(
            instance(std::uint32_t(i % 3), placed(at, turn, uniform(random, 0.7F, 1.3F))));
    }
    return aggregate_of({tests::component("torus", {{"radius", 0.01}}),
                         tests::component("box", {{"width", 0.015}}),
                         tests::component("sphere", {{"radius", 0.008}})},
                        instances);
}

TEST(FabricationExact, CellsSeparateTheirCornersWithoutSelfIntersections) {
    Random random(1, Purpose::test, 0);
    for (unsigned inside = 1; inside < 255; ++inside)
        for (int turn = 0; turn < 40; ++turn) {
            std::vector<Point> points;
            for (int e = 0; e < 12; ++e) {
                const CellEdge edge = cell_edge(e);
                std::array<double, 3> p{double(edge.lower & 1), double(edge.lower >> 1 & 1),
                                        double(edge.lower >> 2)};
                const double u = random.uniform(); // surfaces come close at the ends of edges
                p[std::size_t(edge.axis)] = u < 0.35 ? 0.02 : u > 0.65 ? 0.98 : u;
                points.emplace_back(p[0], p[1], p[2]);
            }
            std::vector<std::array<std::size_t, 3>> faces;
            for (const auto& t : cell_surface(inside))
                faces.push_back({t[0], t[1], t[2]});
            ASSERT_FALSE(faces.empty());
            ASSERT_TRUE(PMP::is_polygon_soup_a_polygon_mesh(faces)) << inside;
            Surface surface;
            PMP::polygon_soup_to_polygon_mesh(points, faces, surface);
            ASSERT_FALSE(PMP::does_self_intersect(surface)) << inside;
        }
}

TEST(FabricationExact, HeapsAreSolid) {
    const Aggregate aggregate = heap(60);
    FabricationOptions options;
    for (const double resolution : {0.0009, 0.002, 0.005}) {
        options.resolution = resolution;
        expect_solid(fabricate({&aggregate, 1}, options, {}), 1);
    }
}

TEST(FabricationExact, AllPartsAndVoidsAreSolid) {
    const Aggregate aggregate = heap(40);
    FabricationOptions options;
    options.resolution = 0.0015;
    options.keep_parts = true;
    options.keep_voids = true;
    const Fabrication made = fabricate({&aggregate, 1}, options, {});
    EXPECT_TRUE(made.removed.empty());
    expect_solid(made, made.parts.size() + made.voids);
}

TEST(FabricationExact, BridgedHeapsAreSolid) {
    const Aggregate aggregate = heap(40);
    FabricationOptions options;
    options.resolution = 0.0015;
    options.bridge = 0.004;
    expect_solid(fabricate({&aggregate, 1}, options, {}), 1);
}

// With facets in lattice planes, where the distances at lattice points are 0.
TEST(FabricationExact, BoxesOnTheLatticeAreSolid) {
    const Prototype box = tests::component("box", {{"width", 0.01}});
    const Aggregate aggregate =
        aggregate_of({box}, {instance(0, placed({0, 0, 0})), instance(0, placed({0.01F, 0, 0})),
                             instance(0, placed({0.005F, 0.01F, 0})),
                             instance(0, placed({0.015F, 0.02F, 0.01F})),
                             instance(0, placed({-0.01F, 0.01F, 0.01F}))});
    FabricationOptions options;
    options.resolution = 0.001;
    options.keep_parts = true;
    const Fabrication made = fabricate({&aggregate, 1}, options, {});
    expect_solid(made, made.parts.size());
}

} // namespace
} // namespace scree
