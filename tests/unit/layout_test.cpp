// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/parallel.h"
#include "generators/layout/gap_field.h"
#include "generators/layout/method.h"
#include "generators/layout/prototypes.h"
#include "geometry/figures/overlap.h"
#include "geometry/plane/ground_plane.h"
#include "geometry/plane/region_shapes.h"
#include "tests/support/aggregates.h"
#include "tests/support/errors.h"
#include "tests/support/layout_params.h"
#include "tests/support/regions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace scree {

namespace {

using tests::component;
using tests::error_of;
using tests::fact;
using tests::layout_params;
using tests::region_of;

std::string message_of(const Params& params) {
    return error_of([&] { layout_plugin().make(params)({}); });
}

bool same(const Aggregate& a, const Aggregate& b) {
    return std::equal(a.instances.begin(), a.instances.end(), b.instances.begin(),
                      b.instances.end(), [](const Instance& x, const Instance& y) {
                          return x.prototype == y.prototype && x.random == y.random &&
                                 x.world_from_object == y.world_from_object;
                      });
}

Params two_shapes(const std::string& method) {
    Params params = layout_params(region_of(rectangle_ring(3, 2)),
                                  {component(0, region_of(l_ring(0.3, 0.1))),
                                   component(1, region_of(star_ring(0.2, 0.4, 5)))});
    params.set("method", method);
    params.set("scale", Range{0.6, 1.2});
    params.set("cancellations", std::int64_t{method == "naive" ? 1000 : 200});
    params.set("resolution", std::int64_t{200});
    return params;
}

TEST(Layout, IsTheSameOnAnyThreadsAndDevice) {
    for (const std::string method : {"naive", "fill_gap"}) {
        const Params params = two_shapes(method);
        Aggregate one;
        {
            const ThreadLimit limit(1);
            one = layout_plugin().make(params)({});
        }
        const ThreadLimit limit(2);
        EXPECT_GT(one.instances.size(), 20U);
        EXPECT_TRUE(same(one, layout_plugin().make(params)({})));
        Device device;
        EXPECT_TRUE(same(one, layout_plugin().make(params)({.device = &device})));
        Params other = params;
        other.set("seed", std::int64_t{1});
        EXPECT_FALSE(same(one, layout_plugin().make(other)({})));
    }
}

TEST(Layout, MatrixPutsTheRegionsCentreAtThePosition) {
    const WideMatrix matrix = world_from_element({2, 3}, {10, 20}, pi / 2, 2, 0.5);
    const Vec3 centre = transform_point(matrix, {2, 0, 3});
    EXPECT_NEAR(double((centre - Vec3(10, 0.5F, 20)).length()), 0, 1e-5);
    // One to the right of it, turned from +x towards +z and twice as far.
    const Vec3 right = transform_point(matrix, {3, 1, 3});
    EXPECT_NEAR(double((right - Vec3(10, 2.5F, 22)).length()), 0, 1e-5);
}

TEST(Layout, FactsAddUp) {
    Params params = two_shapes("naive");
    std::vector<Params> components = params.list("components");
    components[0].set("margin", 0.02);
    params.set("components", std::make_shared<const std::vector<Params>>(components));
    const Aggregate aggregate = layout_plugin().make(params)({});
    double bare = 0;
    for (const Instance& instance : aggregate.instances)
        bare +=
            double(instance.scale) * double(instance.scale) *
            (instance.prototype == 0 ? 0.3 * 0.1 + 0.2 * 0.1 : signed_area(star_ring(0.2, 0.4, 5)));
    EXPECT_NEAR(fact(aggregate, "fill"), bare / 6, 1e-6);
    EXPECT_GT(fact(aggregate, "fill_with_margin"), fact(aggregate, "fill"));
    EXPECT_EQ(fact(aggregate, "count"), double(aggregate.instances.size()));
    EXPECT_EQ(fact(aggregate, "trials"),
              fact(aggregate, "count") + fact(aggregate, "cancellations"));
}

TEST(Layout, AnglesAndScalesAreKeptInDouble) {
    Params params = two_shapes("naive");
    params.set("rotation", Range{0.3, 0.3});
    params.set("scale", Range{0.7, 0.7});
    params.set("max_count", std::int64_t{3});
    const Aggregate aggregate = layout_plugin().make(params)({});
    ASSERT_EQ(aggregate.instances.size(), 3U);
    for (const Instance& instance : aggregate.instances) {
        EXPECT_EQ(instance.angle, 0.3);
        EXPECT_EQ(instance.scale, 0.7);
    }
}

LayoutProblem problem_with(std::vector<double> weights, Selection selection) {
    LayoutProblem problem{.domain = DomainTest(region_of(rectangle_ring(3, 2)), Inside::whole),
                          .seed = 5};
    for (const double weight : weights) {
        problem.shapes.emplace_back(*region_of(l_ring(0.3, 0.1)));
        problem.weights.push_back(weight);
    }
    problem.selection = selection;
    return problem;
}

TEST(Selection, CyclicTakesEachInTurn) {
    const LayoutProblem problem = problem_with({1, 1, 1}, Selection::cyclic);
    for (std::uint64_t trial = 0; trial < 12; ++trial)
        EXPECT_EQ(throw_dart(problem, trial)->component, trial % 3);
}

TEST(Selection, WeightedFollowsTheWeights) {
    const std::vector<double> weights = {1, 2, 5};
    const LayoutProblem problem = problem_with(weights, Selection::weighted);
    std::vector<double> counts(3);
    constexpr int trials = 40000;
    for (std::uint64_t trial = 0; trial < trials; ++trial)
        ++counts[throw_dart(problem, trial)->component];
    double chi2 = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double expected = trials * weights[i] / 8;
        chi2 += (counts[i] - expected) * (counts[i] - expected) / expected;
    }
    EXPECT_LT(chi2, 13.8); // 0.999 quantile, 2 degrees of freedom
}

TEST(Selection, DartsAreUniformOverTheDomain) {
    const LayoutProblem problem = problem_with({1}, Selection::cyclic);
    std::vector<double> counts(24);
    constexpr int trials = 24000;
    for (std::uint64_t trial = 0; trial < trials; ++trial) {
        const Vec2 p = throw_dart(problem, trial)->pose.position + Vec2(1.5, 1);
        ++counts[std::size_t(p.y * 2) * 6 + std::size_t(p.x * 2)];
    }
    double chi2 = 0;
    for (const double count : counts)
        chi2 += (count - 1000) * (count - 1000) / 1000;
    EXPECT_LT(chi2, 49.7); // 0.999 quantile, 23 degrees of freedom
}

/// Distance between two outlines by all pairs of edges, 0 where they cross.
double distance_between(const std::vector<Ring>& a, const std::vector<Ring>& b) {
    double nearest = 1e9;
    for (const Ring& ra : a)
        for (std::size_t i = 0, j = ra.size() - 1; i < ra.size(); j = i++)
            for (const Ring& rb : b)
                for (std::size_t k = 0, l = rb.size() - 1; k < rb.size(); l = k++) {
                    nearest = std::min({nearest, segment_distance(ra[i], rb[k], rb[l]),
                                        segment_distance(rb[k], ra[i], ra[j])});
                    const double s = cross(ra[i] - ra[j], rb[k] - ra[j]);
                    const double t = cross(ra[i] - ra[j], rb[l] - ra[j]);
                    const double u = cross(rb[k] - rb[l], ra[i] - rb[l]);
                    const double v = cross(rb[k] - rb[l], ra[j] - rb[l]);
                    if ((s < 0) != (t < 0) && (u < 0) != (v < 0))
                        nearest = 0;
                }
    return nearest;
}

TEST(Overlap, AgreesWithBruteForce) {
    const Ring hole = circle_ring(0.42, 30);
    const std::vector<Region> regions = {
        triangulate({l_ring(1, 0.3)}), triangulate({star_ring(0.5, 0.3, 5)}),
        triangulate({chevron_ring(1, 0.2)}), triangulate({u_ring(1, 0.2)}),
        triangulate({circle_ring(0.5, 50), hole})};
    const std::vector<CollisionShape> shapes(regions.begin(), regions.end());
    Random random(9, Purpose::test);
    int hits = 0, misses = 0, held = 0;
    for (int i = 0; i < 20000; ++i) {
        const CollisionShape& a = shapes[random.below(5)];
        const CollisionShape& b = shapes[random.below(5)];
        const FigurePose pa({random.uniform(-1, 1), random.uniform(-1, 1)},
                            random.uniform(0, 2 * pi), std::exp(random.uniform(-3, 0.5)));
        const FigurePose pb({0.1, -0.2}, random.uniform(0, 2 * pi), 1);
        Region placed_a = a.outline(), placed_b = b.outline();
        for (Ring& ring : placed_a.rings)
            for (Vec2& v : ring)
                v = pa.apply(v);
        for (Ring& ring : placed_b.rings)
            for (Vec2& v : ring)
                v = pb.apply(v);
        const double gap = distance_between(placed_a.rings, placed_b.rings);
        const bool holds =
            contains(placed_a, placed_b.rings[0][0]) || contains(placed_b, placed_a.rings[0][0]);
        const bool expected = gap == 0 || holds;
        const double doubt = 1e-5 * (a.radius() * pa.scale + b.radius() * pb.scale);
        const bool answer = overlap(a, pa, b, pb, pa.position - pb.position);
        if (expected || gap > doubt) {
            ASSERT_EQ(answer, expected) << i << " gap " << gap;
        }
        hits += expected ? 1 : 0;
        misses += expected ? 0 : 1;
        held += gap > 0 && holds ? 1 : 0;
    }
    EXPECT_GT(hits, 2000);
    EXPECT_GT(misses, 2000);
    EXPECT_GT(held, 150);
}

TEST(Overlap, KeepsTheClearance) {
    const CollisionShape square(*region_of(rectangle_ring(1, 1)));
    const FigurePose here({0, 0}, 0, 1);
    for (const double gap : {0.05, 0.099, 0.101, 0.2}) {
        const FigurePose there({1 + gap, 0}, 0, 1);
        EXPECT_EQ(overlap(square, there, square, here, there.position, 0.1), gap < 0.1) << gap;
        EXPECT_FALSE(overlap(square, there, square, here, there.position, 0));
    }
}

/// The exact squared distance of each pixel by looking at all others.
std::vector<std::uint32_t> brute_force_distances(const GapField& field) {
    std::vector<std::uint32_t> result(field.state().size());
    for (int y = 0; y < field.height(); ++y) {
        for (int x = 0; x < field.width(); ++x) {
            int nearest = std::numeric_limits<int>::max();
            for (int v = 0; v < field.height(); ++v)
                for (int u = 0; u < field.width(); ++u)
                    if ((field.state()[std::size_t(v * field.width() + u)] & 1U) != 0)
                        nearest = std::min(nearest, (u - x) * (u - x) + (v - y) * (v - y));
            result[std::size_t(y * field.width() + x)] = std::uint32_t(nearest);
        }
    }
    return result;
}

TEST(GapField, DistancesAreExact) {
    const DomainTest domain(region_of(l_ring(2, 1.1)), Inside::whole);
    GapField field(domain, 70, nullptr);
    const CollisionShape star(*region_of(star_ring(0.2, 0.4, 5)));
    field.occupy(star.outline(), FigurePose({-0.5, -0.4}, 0.3, 1));
    field.occupy(star.outline(), FigurePose({0.5, -0.5}, 0.7, 0.5));
    field.candidates(16, 1, 0);
    EXPECT_EQ(field.squared_distance(), brute_force_distances(field));
}

TEST(GapField, DeviceAndHostGiveTheSameBytes) {
    Device device;
    for (const Inside inside : {Inside::whole, Inside::centre}) {
        const DomainTest domain(region_of(l_ring(2, 1.1)), inside);
        GapField host(domain, 301, nullptr), other(domain, 301, &device);
        const CollisionShape star(*region_of(star_ring(0.2, 0.4, 5)));
        for (std::uint64_t round = 0; round < 6; ++round) {
            for (const std::uint32_t exponent : {1U, 3U, 16U}) {
                EXPECT_EQ(host.candidates(exponent, 77, round),
                          other.candidates(exponent, 77, round));
                EXPECT_EQ(host.squared_distance(), other.squared_distance());
                EXPECT_EQ(host.marks(), other.marks());
                EXPECT_GT(std::accumulate(host.marks().begin(), host.marks().end(), 0), 0);
            }
            const FigurePose pose({-0.8 + 0.3 * double(round), -0.6}, double(round), 1);
            host.occupy(star.outline(), pose);
            other.occupy(star.outline(), pose);
        }
    }
}

TEST(GapField, CandidatesFollowThePowerOfTheDistance) {
    const DomainTest domain(region_of(rectangle_ring(1, 1)), Inside::whole);
    for (const std::uint32_t exponent : {1U, 5U, 16U}) {
        GapField field(domain, 128, nullptr);
        // Pixels in classes by probability, each class's count against its expectation.
        constexpr std::size_t classes = 8;
        std::vector<double> expected(classes), variance(classes), seen(classes);
        for (std::uint64_t round = 0; round < 40; ++round) {
            field.candidates(exponent, 3, round);
            const auto& squared = field.squared_distance();
            const double maximum = *std::max_element(squared.begin(), squared.end());
            for (std::size_t i = 0; i < squared.size(); ++i) {
                if (squared[i] == 0)
                    continue;
                const double p = std::pow(std::sqrt(squared[i] / maximum), exponent);
                const auto c = std::min(classes - 1, std::size_t(p * classes));
                expected[c] += p;
                variance[c] += p * (1 - p);
                seen[c] += field.marks()[i];
            }
        }
        double chi2 = 0;
        for (std::size_t c = 0; c < classes; ++c)
            if (variance[c] > 0)
                chi2 += (seen[c] - expected[c]) * (seen[c] - expected[c]) / variance[c];
        EXPECT_LT(chi2, 26.1) << exponent; // 0.999 quantile, 8 degrees of freedom
        EXPECT_GT(seen[classes - 1], 100);
    }
}

TEST(LayoutErrors, NameComponentAndSizes) {
    Params params = layout_params(region_of(rectangle_ring(0.3, 0.3)),
                                  {component(0, region_of(l_ring(0.1, 0.03))),
                                   component(1, region_of(rectangle_ring(0.5, 0.4)))});
    EXPECT_EQ(
        message_of(params),
        "scene.lua:21: generator.layout.components[2].shape: the region of component_1, 0.5 x "
        "0.4 m, does not fit the domain, 0.3 x 0.3 m");
    params.set("scale", Range{0.9, 1.2});
    EXPECT_EQ(message_of(params),
              "scene.lua:21: generator.layout.components[2].shape: the region of component_1, 0.45 "
              "x 0.36 m at the smallest scale, does not fit the domain, 0.3 x 0.3 m");
    params.set("scale", Range{0.3, 0.5});
    EXPECT_EQ(message_of(params), "no error");
    params.set("scale", Range{1, 1});
    params.set("inside", std::string("centre"));
    params.set("max_count", std::int64_t{3});
    EXPECT_EQ(message_of(params), "no error");
}

TEST(LayoutErrors, FitsOnlyWhenTurned) {
    Params params = layout_params(region_of(rectangle_ring(1.0, 0.2)),
                                  {component(0, region_of(rectangle_ring(0.1, 0.9)))});
    params.set("max_count", std::int64_t{1});
    params.set("method", std::string("naive"));
    EXPECT_EQ(message_of(params), "no error");
    params.set("rotation", Range{0, 0});
    EXPECT_EQ(
        message_of(params),
        "scene.lua:20: generator.layout.components[1].shape: the region of component_0, 0.1 x "
        "0.9 m, does not fit the domain, 1 x 0.2 m");
}

TEST(LayoutErrors, LocateMarginAndEmptyDomain) {
    Params small = component(0, region_of(l_ring(0.1, 0.03)));
    small.set("margin", -0.05, {"scene.lua", 55});
    EXPECT_EQ(message_of(layout_params(region_of(rectangle_ring(1, 1)), {small})),
              "scene.lua:55: generator.layout.components[1].margin: a margin of -0.05 m leaves "
              "nothing of the region");
    EXPECT_EQ(message_of(layout_params(std::make_shared<const Region>(),
                                       {component(0, region_of(l_ring(0.1, 0.03)))})),
              "scene.lua:9: generator.layout.domain: the domain has no area");
}

TEST(LayoutErrors, KeepTheKindOfAFaultThatIsNotTheInputs) {
    Context context;
    context.progress = [](std::string_view, double) { throw Error::resource("out of memory"); };
    for (const std::string method : {"naive", "fill_gap", "saturated"}) {
        Params params = two_shapes(method);
        params.set("epsilon", 0.2);
        params.set("cancellations", std::int64_t{3000});
        params.set("max_count", std::int64_t{1000000});
        try {
            layout_plugin().make(params)(context);
            ADD_FAILURE() << method;
        } catch (const Error& error) {
            EXPECT_EQ(error.fault(), Fault::resource) << method;
            EXPECT_STREQ(error.what(), "out of memory") << method;
        }
    }
}

TEST(Layout, CanBeCancelled) {
    Cancel cancel;
    cancel.request();
    EXPECT_THROW(layout_plugin().make(two_shapes("naive"))({.cancel = &cancel}), Cancelled);
    EXPECT_THROW(layout_plugin().make(two_shapes("fill_gap"))({.cancel = &cancel}), Cancelled);
}

} // namespace

} // namespace scree
