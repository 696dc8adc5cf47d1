// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/parallel.h"
#include "generators/elements/class_sizes.h"
#include "generators/elements/exclusive_ellipse.h"
#include "geometry/plane/ground_plane.h"
#include "geometry/plane/region_shapes.h"
#include "geometry/plane/region_tools.h"
#include "geometry/sampling/poisson_disk.h"
#include "shapes/field/plain_fields.h"
#include "tests/support/aggregates.h"
#include "tests/support/elements_params.h"
#include "tests/support/regions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace scree {
namespace {

using tests::fact;
using tests::region_of;

Ring ellipse_ring(double length, double width, const Vec2& centre = Vec2(0.0)) {
    Ring ring = circle_ring(1, 64);
    for (Vec2& v : ring)
        v = v * Vec2(length, width) + centre;
    return ring;
}

Params component(const Ring& ring) { return tests::element_component(region_of(ring)); }

Params elements(const Ring& domain, std::vector<Params> components) {
    Params params = tests::elements_params(std::move(components));
    params.set("domain", region_of(domain), {"scene.lua", 9});
    return params;
}

Aggregate bake(const Params& params) { return elements_plugin().make(params)({}); }

Vec2 position(const Instance& instance) {
    return ground_point(Vec2(0.0), instance.world_from_object);
}

/// How far the middle of `other` lies into the ellipse around `of`: below 1 it is inside.
double depth(const Instance& of, const EllipseAxes& axes, const Instance& other) {
    const Vec2 seen = rotate(position(other) - position(of), -of.angle);
    return std::hypot(seen.x / axes.length, seen.y / axes.width) / of.scale;
}

bool is_left_of(const Vec2& a, const Vec2& b, const Vec2& p) { return cross(b - a, p - a) > 0; }

/// Whether two convex rings overlap: no edge of either has all of the other on its right.
bool overlap(const Ring& a, const Ring& b) {
    const auto separates = [](const Ring& edges, const Ring& points) {
        for (std::size_t i = 0; i < edges.size(); ++i)
            if (std::none_of(points.begin(), points.end(), [&](const Vec2& p) {
                    return is_left_of(edges[i], edges[(i + 1) % edges.size()], p);
                }))
                return true;
        return false;
    };
    return !separates(a, b) && !separates(b, a);
}

std::size_t overlapping_pairs(const Aggregate& aggregate) {
    std::vector<Ring> rings;
    for (const Instance& instance : aggregate.instances)
        rings.push_back(ground_region(*aggregate.prototypes[instance.prototype].region,
                                      instance.world_from_object)
                            .rings[0]);
    std::size_t count = 0;
    for (std::size_t i = 0; i < rings.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            count += overlap(rings[i], rings[j]);
    return count;
}

TEST(Ellipse, EnclosingTheLeastAreaTouchesTheCorners) {
    const EllipseAxes box = enclosing_ellipse(triangulate({rectangle_ring(4, 1)}));
    EXPECT_NEAR(box.length, 2 * std::sqrt(2), 1e-6); // a flat optimum
    EXPECT_NEAR(box.width, 0.5 * std::sqrt(2), 1e-6);
    const EllipseAxes same = enclosing_ellipse(triangulate({ellipse_ring(0.3, 0.7, {5, 6})}));
    EXPECT_NEAR(same.length, 0.3, 1e-9);
    EXPECT_NEAR(same.width, 0.7, 1e-9);
    const EllipseAxes star = enclosing_ellipse(triangulate({star_ring(1, 0.4, 5)}));
    const Region region = triangulate({star_ring(1, 0.4, 5)});
    const Vec2 centre = bounds(region).center();
    for (const Vec2& v : region.rings[0])
        EXPECT_LE(std::hypot((v.x - centre.x) / star.length, (v.y - centre.y) / star.width),
                  1 + 1e-9);
    EXPECT_DOUBLE_EQ(enclosing_disk(triangulate({rectangle_ring(3, 4)})).length, 2.5);
}

TEST(Ellipse, ExclusiveIsTwiceAsLargeForElementsThatLieAlike) {
    const EllipseAxes alike = exclusive_ellipse({0.3, 0.1}, 0);
    EXPECT_DOUBLE_EQ(alike.length, 0.6);
    EXPECT_DOUBLE_EQ(alike.width, 0.2);
    const EllipseAxes disk = exclusive_ellipse({0.3, 0.3}, pi);
    EXPECT_DOUBLE_EQ(disk.length, 0.6);
    EXPECT_DOUBLE_EQ(disk.width, 0.6);
    double before = alike.mean();
    for (const double spread : {0.05, 0.2, 0.6, pi / 2}) {
        const double mean = exclusive_ellipse({0.3, 0.1}, spread).mean();
        EXPECT_GT(mean, before);
        EXPECT_LT(mean, 0.55);
        before = mean;
    }
    EXPECT_DOUBLE_EQ(exclusive_ellipse({0.3, 0.1}, 2 * pi).mean(), before);
    const EllipseAxes along = exclusive_ellipse({0.3, 0.1}, 0.2);
    const EllipseAxes across = exclusive_ellipse({0.1, 0.3}, 0.2);
    EXPECT_DOUBLE_EQ(across.width, along.length);
    EXPECT_DOUBLE_EQ(across.length, along.width);
}

TEST(Ellipse, ClassesOfDisksKeepTheMeanOfTheirDiameters) {
    const ElementRoom a{{0.1, 0.1}, {0.2, 0.2}}, b{{0.3, 0.3}, {0.6, 0.6}};
    EXPECT_NEAR(class_distance(a, b, pi), 0.4, 1e-6);
    const ElementRoom slim{{0.4, 0.1}, {0.8, 0.2}};
    EXPECT_NEAR(class_distance(slim, slim, 0), slim.exclusive.mean(), 1e-3);
    EXPECT_NEAR(class_distance(a, slim, 0), class_distance(slim, a, 0), 1e-12);
}

TEST(ClassSizes, KeepDifferentElementsApartAndHaveTheShares) {
    const std::vector<double> least{0.1, 0.15, 0.12, 0.15, 0.2, 0.18, 0.12, 0.18, 0.15};
    const std::vector<double> sizes = class_sizes(least, {3, 1, 2});
    EXPECT_NEAR(sizes[0] * sizes[0] * 3, sizes[1] * sizes[1], 1e-12);
    EXPECT_NEAR(sizes[2] * sizes[2] * 2, sizes[1] * sizes[1], 1e-12);
    const std::vector<double> matrix = class_distances(sizes);
    double smallest = 1e9;
    for (std::size_t i = 0; i < least.size(); ++i)
        smallest = std::min(smallest, matrix[i] / least[i]);
    EXPECT_NEAR(smallest, 1, 1e-12);
}

TEST(Elements, KeepOutOfEachOthersEllipses) {
    Params params = elements(rectangle_ring(3, 2), {component(rectangle_ring(0.1, 0.04))});
    params.set("direction",
               std::shared_ptr<const Field>(std::make_shared<WhirlField>(Vec2(0.3, 0.1), 60.0)));
    params.set("scale_by", std::shared_ptr<const Field>(std::make_shared<GradientField>(
                               Vec2(-1, 0), Vec2(1, 0), Range{0.7, 1.4}, false)));
    const Aggregate aggregate = bake(params);
    const EllipseAxes axes{0.1 * std::sqrt(2), 0.04 * std::sqrt(2)};
    EXPECT_GT(aggregate.instances.size(), 200U);
    EXPECT_TRUE(aggregate.texture);
    for (const Instance& a : aggregate.instances)
        for (const Instance& b : aggregate.instances)
            if (&a != &b) {
                ASSERT_GT(depth(a, axes, b), 1 - 1e-5);
            }
    const WhirlField whirl({0.3, 0.1}, 60);
    for (const Instance& instance : aggregate.instances) {
        const double turn = instance.angle - radians(whirl.at(position(instance)));
        EXPECT_NEAR(std::cos(turn), 1, 1e-6);
        const Vec2 ahead = ground_point({1, 0}, instance.world_from_object) - position(instance);
        EXPECT_NEAR((ahead - rotate({instance.scale, 0}, instance.angle)).length(), 0, 1e-5);
    }
    EXPECT_EQ(fact(aggregate, "count"), double(aggregate.instances.size()));
    double scale2 = 0;
    for (const Instance& instance : aggregate.instances)
        scale2 += instance.scale * instance.scale;
    EXPECT_NEAR(fact(aggregate, "fill"), 0.004 * scale2 / 6, 1e-9);
    EXPECT_NEAR(fact(aggregate, "fill_with_margin"), pi * 0.002 * scale2 / 6, 1e-9);
}

TEST(Elements, DoNotOverlapAtAnyTurnOrBetweenClasses) {
    Params leaf = component(ellipse_ring(0.09, 0.025));
    leaf.set("margin", 0.001);
    Params seed = component(ellipse_ring(0.03, 0.03));
    seed.set("weight", 2.0);
    const Params nut = component(ellipse_ring(0.04, 0.05));
    for (const double turn : {0.0, 0.4, 2 * pi}) {
        Params params = elements(rectangle_ring(2, 2), {leaf});
        params.set("rotation", Range{-turn / 2, turn / 2});
        const Aggregate one = bake(params);
        EXPECT_GT(one.instances.size(), 60U);
        EXPECT_EQ(overlapping_pairs(one), 0U);
    }
    const Aggregate mixed = bake(elements(rectangle_ring(2, 2), {leaf, seed, nut}));
    EXPECT_GT(mixed.instances.size(), 150U);
    EXPECT_EQ(overlapping_pairs(mixed), 0U);
}

TEST(Elements, MixEvenlyByShareOrAtRandomByWeight) {
    Params often = component(circle_ring(0.02, 16));
    often.set("weight", 3.0);
    Params params = elements(rectangle_ring(3, 3), {often, component(circle_ring(0.02, 16))});
    for (const std::string mix : {"even", "random"}) {
        params.set("mix", mix);
        const Aggregate aggregate = bake(params);
        EXPECT_NEAR(fact(aggregate, "share_1"), 0.75, 0.06) << mix;
        EXPECT_EQ(fact(aggregate, "count_1") + fact(aggregate, "count_2"),
                  fact(aggregate, "count"));
        std::vector<double> counts(2);
        for (const Instance& instance : aggregate.instances)
            ++counts[instance.prototype];
        EXPECT_EQ(counts[0], fact(aggregate, "count_1")) << mix;
        EXPECT_EQ(overlapping_pairs(aggregate), 0U);
        // Evenly mixed, the rarer ones keep farther apart than in a random mix.
        double nearest = 1e9;
        for (const Instance& a : aggregate.instances)
            for (const Instance& b : aggregate.instances)
                if (&a != &b && a.prototype == 1 && b.prototype == 1)
                    nearest = std::min(nearest, (position(a) - position(b)).length());
        EXPECT_EQ(nearest > 0.07, mix == "even") << mix;
    }
}

TEST(Elements, StandFartherApartWhereTheSpacingSays) {
    const auto ramp = [](double low, double high) -> std::shared_ptr<const Field> {
        return std::make_shared<GradientField>(Vec2(-1, 0), Vec2(1, 0), Range{low, high}, false);
    };
    Params params = elements(rectangle_ring(2, 1), {component(circle_ring(0.01, 32))});
    params.set("spacing_by", ramp(1, 4));
    params.set("scale_by", ramp(1, 2));
    const Aggregate aggregate = bake(params);
    std::size_t left = 0;
    for (std::size_t i = 0; i < aggregate.instances.size(); ++i) {
        const Instance& a = aggregate.instances[i];
        const auto grown = [](const Instance& instance) { return (position(instance).x + 1) / 2; };
        EXPECT_NEAR(a.scale, 1 + grown(a), 1e-5);
        left += position(a).x < 0 ? 1 : 0;
        for (std::size_t j = 0; j < i; ++j) {
            const Instance& b = aggregate.instances[j];
            const double least =
                0.02 * std::max(a.scale * (1 + 3 * grown(a)), b.scale * (1 + 3 * grown(b)));
            EXPECT_GT((position(a) - position(b)).length(), least * (1 - 1e-5));
        }
    }
    // The density falls as 1 / (scale * spacing)^2: by 4.3 from the left half to the right.
    EXPECT_GT(double(left), 3 * double(aggregate.instances.size() - left));
}

TEST(Elements, GivenSizesAreUsedAsTheyAre) {
    Params given = component(circle_ring(0.01, 16));
    given.set("length", 0.2);
    given.set("width", 0.1);
    const Aggregate aggregate = bake(elements(rectangle_ring(3, 3), {given}));
    double nearest = 1e9;
    for (const Instance& a : aggregate.instances)
        for (const Instance& b : aggregate.instances)
            if (&a != &b)
                nearest = std::min(nearest, depth(a, {0.2, 0.1}, b));
    EXPECT_GT(nearest, 1 - 1e-5);
    EXPECT_LT(nearest, 1.02);
    // Given one axis, the other follows in the outline's proportions; a disk has the larger one.
    Params length = component(ellipse_ring(0.02, 0.01));
    length.set("length", 0.2);
    const std::size_t count = bake(elements(rectangle_ring(3, 3), {length})).instances.size();
    EXPECT_NEAR(double(count), double(aggregate.instances.size()), 0.05 * double(count));
    Params disks = elements(rectangle_ring(3, 3), {given});
    disks.set("exclusion", std::string("disk"));
    EXPECT_LT(bake(disks).instances.size(), 0.6 * double(count));
}

TEST(Elements, StayWholeInsideOrWrapRound) {
    Params params = elements(circle_ring(1, 64), {component(rectangle_ring(0.2, 0.1))});
    params.set("rotation", Range{0, 2 * pi});
    params.set("inside", std::string("whole"));
    const Region domain = *params.object<Region>("domain");
    const Aggregate inside = bake(params);
    EXPECT_GT(inside.instances.size(), 20U);
    for (const Instance& instance : inside.instances) {
        const Region placed =
            ground_region(*inside.prototypes[0].region, instance.world_from_object);
        for (const Vec2& v : placed.rings[0])
            EXPECT_TRUE(contains(domain, v));
    }
    Params tile = elements(rectangle_ring(2, 1), {component(circle_ring(0.05, 16))});
    tile.set("torus", true);
    const Aggregate aggregate = bake(tile);
    EXPECT_TRUE(aggregate.torus);
    for (const Instance& a : aggregate.instances)
        for (const Instance& b : aggregate.instances) {
            Vec2 apart = position(a) - position(b);
            apart -= Vec2(2 * std::round(apart.x / 2), std::round(apart.y));
            if (&a != &b) {
                EXPECT_GT(apart.length(), 0.1 - 1e-6);
            }
        }
}

TEST(Elements, MayBePicturesOverABackground) {
    const std::string folder = std::string(SCREE_SOURCE_DIR) + "/scenes/parts/pictures/";
    Params leaf = component(circle_ring(1, 8));
    leaf.set("shape", std::monostate{});
    leaf.set("picture", folder + "ginkgo.svg");
    leaf.set("size", 0.1);
    Params params = elements(rectangle_ring(1, 2), {leaf});
    params.set("background", folder + "paper.svg");
    const Aggregate aggregate = bake(params);
    EXPECT_GT(aggregate.instances.size(), 50U);
    const Prototype& prototype = aggregate.prototypes[0];
    ASSERT_TRUE(prototype.picture && prototype.region && prototype.mesh());
    const Vec2 size = bounds(*prototype.region).size();
    EXPECT_NEAR(std::max(size.x, size.y), 0.1, 1e-9);
    ASSERT_TRUE(aggregate.background);
    EXPECT_EQ(aggregate.background->box, bounds(*aggregate.domain));
}

TEST(Elements, DrawTheRegionWhileTheOutlineKeepsOthersAway) {
    Params star = component(star_ring(0.05, 0.3, 5));
    star.set("region", region_of(circle_ring(0.1, 32)));
    const Aggregate aggregate = bake(elements(rectangle_ring(3, 3), {star}));
    EXPECT_EQ(aggregate.prototypes[0].region->rings[0].size(), 10U);
    const double circles = signed_area(circle_ring(0.1, 32)) / 9;
    EXPECT_NEAR(fact(aggregate, "fill"), circles * double(aggregate.instances.size()), 1e-9);
    for (const Instance& a : aggregate.instances)
        for (const Instance& b : aggregate.instances)
            if (&a != &b) {
                ASSERT_GT((position(a) - position(b)).length(), 0.2 - 1e-6);
            }
}

TEST(Elements, AreTheSameOnAnyThreads) {
    Params params = elements(star_ring(1, 0.5, 5), {component(rectangle_ring(0.05, 0.02)),
                                                    component(circle_ring(0.015, 16))});
    params.set("rotation", Range{0, 1});
    Aggregate one;
    {
        const ThreadLimit limit(1);
        one = bake(params);
    }
    const ThreadLimit limit(2);
    const Aggregate two = bake(params);
    ASSERT_EQ(one.instances.size(), two.instances.size());
    EXPECT_GT(one.instances.size(), 100U);
    for (std::size_t i = 0; i < one.instances.size(); ++i) {
        EXPECT_EQ(one.instances[i].world_from_object, two.instances[i].world_from_object);
        EXPECT_EQ(one.instances[i].prototype, two.instances[i].prototype);
        EXPECT_EQ(one.instances[i].random, two.instances[i].random);
    }
    params.set("seed", std::int64_t{1});
    const Aggregate other = bake(params);
    EXPECT_FALSE(other.instances.size() == one.instances.size() &&
                 other.instances[0].world_from_object == one.instances[0].world_from_object);
}

} // namespace
} // namespace scree
