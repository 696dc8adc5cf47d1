// SPDX-License-Identifier: GPL-3.0-or-later
// Rocks by CGAL's predicates: closed, turned outwards, free of self-intersections, and those of a
// mosaic free of each other.
#include "generators/rocks/rocks_generator.h"
#include "geometry/rock/rock.h"
#include "tests/exact/cgal_surface.h"
#include "tests/support/plugin_params.h"
#include "tests/support/regions.h"
#include "tests/support/rocks.h"

#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/box_intersection_d.h>

#include <gtest/gtest.h>

#include <set>

namespace scree {
namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using tests::Point;

void expect_sound(std::uint64_t first, std::uint64_t end, int level) {
    for (std::uint64_t i = first; i < end; ++i) {
        const Mesh mesh = rock_mesh(Rock(tests::extreme_rock(i)).vertices(level), level);
        const tests::Surface surface = tests::cgal_surface(mesh);
        ASSERT_TRUE(CGAL::is_closed(surface)) << i;
        ASSERT_TRUE(PMP::is_outward_oriented(surface)) << i;
        ASSERT_FALSE(PMP::does_self_intersect(surface)) << i;
    }
}

struct Corner {
    std::size_t rock, triangle;
};

/// The pairs of rocks of which triangles meet.
std::size_t meeting_pairs(const std::vector<std::vector<std::array<Point, 3>>>& rocks) {
    using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, Corner>;
    using Triangle = CGAL::Exact_predicates_inexact_constructions_kernel::Triangle_3;
    std::vector<Box> boxes;
    for (std::size_t r = 0; r < rocks.size(); ++r)
        for (std::size_t t = 0; t < rocks[r].size(); ++t) {
            const auto& p = rocks[r][t];
            boxes.emplace_back(p[0].bbox() + p[1].bbox() + p[2].bbox(), Corner{r, t});
        }
    std::set<std::pair<std::size_t, std::size_t>> pairs;
    const auto triangle = [&](const Corner& at) {
        const auto& p = rocks[at.rock][at.triangle];
        return Triangle(p[0], p[1], p[2]);
    };
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
        if (a.info().rock != b.info().rock &&
            CGAL::do_intersect(triangle(a.info()), triangle(b.info())))
            pairs.insert(std::minmax(a.info().rock, b.info().rock));
    });
    return pairs.size();
}

} // namespace

// Ten thousand rocks in all, extreme in every parameter.
TEST(RocksExact, AreSoundOf320Triangles) { expect_sound(0, 8500, 4); }
TEST(RocksExact, AreSoundOf1280Triangles) { expect_sound(8500, 9800, 8); }
TEST(RocksExact, AreSoundOf5120Triangles) { expect_sound(9800, 9980, 16); }
TEST(RocksExact, AreSoundOf20480Triangles) { expect_sound(9980, 10000, 32); }

TEST(RocksExact, NoTwoRocksOfAMosaicMeet) {
    const Plugin<Generator> plugin = rocks_plugin();
    Params large, small;
    for (const ParamSpec& spec : plugin.params)
        if (spec.name == "sizes")
            large = small = tests::defaults(spec.fields, "sizes");
    large.set("radius", 0.12);
    large.set("share", 0.5);
    small.set("radius", 0.03);
    small.set("share", 0.5);
    Registry<Generator> table("generator");
    table.add(plugin);
    const Aggregate mosaic = tests::make(table, "rocks",
                                         {{"method", std::string("mosaic")},
                                          {"domain", tests::shared_square(0.9)},
                                          {"sizes", std::make_shared<const std::vector<Params>>(
                                                        std::vector<Params>{large, small})}})({});
    std::vector<std::vector<std::array<Point, 3>>> rocks;
    for (const Instance& instance : mosaic.instances) {
        const Mesh& mesh = *mosaic.prototypes[instance.prototype].mesh();
        rocks.emplace_back();
        for (const Mesh::Triangle& t : mesh.triangles) {
            std::array<Point, 3> corners;
            for (unsigned k = 0; k < 3; ++k) {
                const WideVec3 p = WideVec3(mesh.positions[t[k]]) * instance.world_from_object;
                corners[k] = Point(p.x, p.y, p.z);
            }
            rocks.back().push_back(corners);
        }
    }
    EXPECT_GT(rocks.size(), 300U);
    EXPECT_EQ(meeting_pairs(rocks), 0U);
}

} // namespace scree
