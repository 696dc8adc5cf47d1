// SPDX-License-Identifier: GPL-3.0-or-later
// The certificate of saturated layouts by brute force: no pose of a fine grid, and none that a
// climb from its best poses finds, keeps more than epsilon from everything.
#include "core/parallel.h"
#include "generators/layout/method.h"
#include "generators/layout/search_problem.h"
#include "geometry/plane/region_shapes.h"
#include "geometry/plane/region_tools.h"
#include "shapes/field/plain_fields.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace scree {

namespace {

std::shared_ptr<const Region> shared(std::vector<Ring> rings) {
    return std::make_shared<Region>(triangulate(std::move(rings)));
}

std::vector<Ring> at(const Region& outline, const Dart& dart, const Vec2& offset = Vec2(0)) {
    std::vector<Ring> rings = outline.rings;
    for (Ring& ring : rings)
        for (Vec2& v : ring)
            v = dart.pose.apply(v) + offset;
    return rings;
}

bool contains(const std::vector<Ring>& rings, const Vec2& p) {
    return scree::contains({.rings = rings, .vertices = {}, .triangles = {}}, p);
}

/// Distance of two outlines by all pairs of edges, 0 where they cross. Ends early with some
/// distance below `enough` once there is one.
double outline_distance(const std::vector<Ring>& a, const std::vector<Ring>& b, double enough) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Ring& ra : a)
        for (std::size_t i = 0, j = ra.size() - 1; i < ra.size(); j = i++)
            for (const Ring& rb : b)
                for (std::size_t k = 0, l = rb.size() - 1; k < rb.size(); l = k++) {
                    const Vec2 &p = ra[j], &q = ra[i], &r = rb[l], &s = rb[k];
                    if ((cross(q - p, r - p) > 0) != (cross(q - p, s - p) > 0) &&
                        (cross(s - r, p - r) > 0) != (cross(s - r, q - r) > 0))
                        return 0;
                    nearest =
                        std::min({nearest, segment_distance(p, r, s), segment_distance(r, p, q)});
                    if (nearest <= enough)
                        return nearest;
                }
    return nearest;
}

/// Distance of two regions, 0 where they overlap.
double distance(const std::vector<Ring>& a, const std::vector<Ring>& b, double enough) {
    return contains(a, b[0][0]) || contains(b, a[0][0]) ? 0 : outline_distance(a, b, enough);
}

/// All placed elements, on a torus with their images.
class Scene {
  public:
    Scene(const LayoutProblem& problem, const std::vector<Dart>& darts) : problem_(problem) {
        const Vec2 size = problem.domain.box().size();
        for (const Dart& dart : darts)
            for (int y = -1; y <= 1; ++y)
                for (int x = -1; x <= 1; ++x) {
                    if (!problem.domain.is_torus() && (x != 0 || y != 0))
                        continue;
                    const Vec2 offset = size * Vec2(x, y);
                    const CollisionShape& shape = problem.shapes[dart.component];
                    obstacles_.push_back({at(shape.outline(), dart, offset),
                                          dart.pose.position + offset,
                                          shape.radius() * dart.pose.scale, dart.margin});
                }
    }

    /// How far the element stays from everything beyond its margins; 0 where it does not fit.
    double clearance(const Dart& dart) const {
        const CollisionShape& shape = problem_.shapes[dart.component];
        const double radius = shape.radius() * dart.pose.scale;
        const std::vector<Ring> rings = at(shape.outline(), dart);
        double least = std::numeric_limits<double>::infinity();
        if (problem_.domain.inside() == Inside::whole) {
            for (const Ring& ring : rings)
                for (const Vec2& v : ring)
                    if (!scree::contains(problem_.domain.region(), v))
                        return 0;
            for (const Ring& border : problem_.domain.region().rings)
                least = std::min(least, outline_distance(rings, {border}, 0));
            least -= dart.margin;
        } else if (!scree::contains(problem_.domain.region(), dart.pose.position)) {
            return 0;
        }
        for (const Obstacle& o : obstacles_) {
            const double margins = dart.margin + o.margin;
            const double gap = (o.position - dart.pose.position).length() - o.radius - radius;
            if (gap - margins >= least)
                continue;
            least = std::min(least, distance(rings, o.rings, margins) - margins);
            if (least <= 0)
                return 0;
        }
        return least;
    }

  private:
    struct Obstacle {
        std::vector<Ring> rings;
        Vec2 position;
        double radius, margin;
    };

    const LayoutProblem& problem_;
    std::vector<Obstacle> obstacles_;
};

/// Random poses of a component within the problem's ranges.
struct Draw {
    Vec2 position;
    double turn, scale;
};

Draw moved(const LayoutProblem& problem, const Draw& from, double step, Random& random) {
    const auto shift = [&] { return step * random.uniform(-1, 1); };
    Draw to = from;
    to.position += Vec2(shift(), shift());
    to.turn += shift() / problem.largest_radius();
    to.scale += shift() / problem.largest_radius();
    if (problem.rotation.high - problem.rotation.low < 2 * pi)
        to.turn = std::clamp(to.turn, problem.rotation.low, problem.rotation.high);
    to.scale = std::clamp(to.scale, problem.scale.low, problem.scale.high);
    return to;
}

/// The largest clearance that a grid and climbs from it find for a component.
double most_room(const LayoutProblem& problem, const Scene& scene, std::uint32_t component,
                 int cells, int angles, int scales) {
    const Box2 box = problem.domain.box();
    Random random(9, Purpose::test);
    double most = 0;
    for (int y = 0; y < cells; ++y)
        for (int x = 0; x < cells; ++x)
            for (int a = 0; a < angles; ++a)
                for (int s = 0; s < scales; ++s) {
                    const auto share = [](int i, int n) { return n < 2 ? 0 : double(i) / (n - 1); };
                    Draw draw{box.min + box.size() * Vec2(share(x, cells), share(y, cells)),
                              problem.rotation.low +
                                  (problem.rotation.high - problem.rotation.low) * a / angles,
                              problem.scale.low +
                                  (problem.scale.high - problem.scale.low) * share(s, scales)};
                    if (!problem.has_class(component, draw.position))
                        continue;
                    const auto room = [&](const Draw& d) {
                        if (!box.intersects(d.position) ||
                            !problem.has_class(component, d.position))
                            return 0.0;
                        return scene.clearance(
                            problem.dart(component, d.position, d.turn, d.scale));
                    };
                    double best = room(draw);
                    // Climbing from a pose that is nearly free finds maxima between grid points.
                    for (int i = 0; best > 0 && i < 60; ++i) {
                        const double step = 0.02 * std::exp2(-i / 10.0);
                        const Draw next = moved(problem, draw, step, random);
                        const double value = room(next);
                        if (value > best) {
                            best = value;
                            draw = next;
                        }
                    }
                    most = std::max(most, best);
                }
    return most;
}

LayoutProblem problem_on(std::shared_ptr<const Region> domain, Inside inside,
                         const std::vector<Ring>& rings, std::uint64_t seed) {
    LayoutProblem problem{.domain = DomainTest(std::move(domain), inside), .seed = seed};
    for (const Ring& ring : rings) {
        problem.shapes.emplace_back(triangulate({ring}));
        problem.weights.push_back(1);
        problem.classes.push_back(static_cast<long>(problem.classes.size()) + 1);
    }
    return problem;
}

struct Filled {
    std::vector<Dart> darts;
    Certificate certificate;
};

Filled fill(const LayoutProblem& problem, double epsilon, const std::vector<Dart>& before = {}) {
    Filled result;
    Placements placements(problem);
    for (const Dart& dart : before)
        placements.place(dart);
    fill_saturated(problem, {.epsilon = epsilon}, placements, result.certificate, {});
    result.darts = placements.darts();
    return result;
}

/// Everything placed keeps its margins, and no more fits.
void check(const LayoutProblem& problem, double epsilon, int cells, int angles, int scales = 1) {
    const Filled filled = fill(problem, epsilon);
    ASSERT_GT(filled.darts.size(), 2U);
    EXPECT_EQ(filled.certificate.undecided, 0U);
    EXPECT_TRUE(filled.certificate.is_complete);
    EXPECT_EQ(filled.certificate.epsilon, epsilon);
    for (std::size_t i = 0; i < filled.darts.size(); ++i) {
        std::vector<Dart> others = filled.darts;
        others.erase(others.begin() + std::ptrdiff_t(i));
        EXPECT_GT(Scene(problem, others).clearance(filled.darts[i]), 0);
    }
    const Scene scene(problem, filled.darts);
    for (std::uint32_t c = 0; c < problem.shapes.size(); ++c)
        EXPECT_LT(most_room(problem, scene, c, cells, angles, scales), epsilon);
}

class Certified : public testing::TestWithParam<std::tuple<std::string, std::string>> {};

TEST_P(Certified, NoPoseOfAFineGridIsFree) {
    const auto& [name, space] = GetParam();
    const Ring ring = name == "l"         ? l_ring(1, 0.3)
                      : name == "star"    ? star_ring(0.6, 0.4, 5)
                      : name == "chevron" ? chevron_ring(1, 0.25)
                      : name == "u"       ? u_ring(1, 0.25)
                                          : rectangle_ring(0.7, 0.7);
    std::shared_ptr<const Region> domain = shared({rectangle_ring(3.1, 2.9)});
    Inside inside = Inside::torus;
    if (space == "pierced") {
        Ring hole = circle_ring(0.4, 12);
        for (Vec2& v : hole)
            v += Vec2(-0.8, -0.6);
        std::reverse(hole.begin(), hole.end());
        domain = shared({l_ring(3.4, 1.9), hole});
        inside = Inside::whole;
    } else if (space == "centre") {
        domain = shared({star_ring(1.8, 0.5, 6)});
        inside = Inside::centre;
    }
    for (std::uint64_t seed = 0; seed < 2; ++seed) {
        const LayoutProblem problem = problem_on(domain, inside, {ring}, seed);
        check(problem, 0.05 * problem.smallest_inner_radius(), 44, 60);
    }
}

INSTANTIATE_TEST_SUITE_P(All, Certified,
                         testing::Combine(testing::Values("l", "star", "chevron", "u", "square"),
                                          testing::Values("torus", "pierced", "centre")),
                         [](const auto& test) {
                             return std::get<0>(test.param) + "_" + std::get<1>(test.param);
                         });

TEST(CertifiedMixed, ThreeKindsOfManyScales) {
    LayoutProblem problem =
        problem_on(shared({rectangle_ring(3.6, 3.4)}), Inside::torus,
                   {l_ring(1, 0.3), u_ring(0.9, 0.2), star_ring(0.5, 0.4, 5)}, 3);
    problem.scale = {0.6, 0.8};
    check(problem, 0.1 * problem.smallest_inner_radius(), 34, 40, 4);
}

TEST(CertifiedFields, DirectionsWithJitter) {
    LayoutProblem problem =
        problem_on(shared({rectangle_ring(3, 3)}), Inside::whole, {rectangle_ring(0.9, 0.2)}, 4);
    problem.fields.direction = std::make_shared<WhirlField>(Vec2(0.3, 2), 90);
    problem.rotation = {-0.2, 0.2};
    check(problem, 0.1 * problem.smallest_inner_radius(), 90, 9);
}

TEST(CertifiedFields, ScalesAndMarginsByPlace) {
    LayoutProblem problem = problem_on(shared({rectangle_ring(2.4, 2.4)}), Inside::whole,
                                       {u_ring(0.6, 0.15), star_ring(0.3, 0.4, 5)}, 5);
    problem.fields.scale =
        std::make_shared<GradientField>(Vec2(-1, 0), Vec2(1, 0), Range{0.7, 1.3}, false);
    problem.fields.density =
        std::make_shared<GradientField>(Vec2(0, -1), Vec2(0, 1), Range{0, 2}, false);
    problem.margins = {0.02, 0.01};
    check(problem, 0.15 * problem.smallest_inner_radius(), 44, 40);
}

TEST(CertifiedFields, ClassesKeepToTheirPlaces) {
    LayoutProblem problem = problem_on(shared({rectangle_ring(3, 3)}), Inside::whole,
                                       {l_ring(0.6, 0.2), star_ring(0.3, 0.4, 5)}, 6);
    problem.fields.classes =
        std::make_shared<GradientField>(Vec2(-0.5, 0), Vec2(0.5, 0), Range{1, 2}, false);
    check(problem, 0.1 * problem.smallest_inner_radius(), 60, 40);
    for (const Dart& dart : fill(problem, 0.01).darts)
        EXPECT_EQ(dart.component, dart.pose.position.x < 0 ? 0U : 1U);
}

TEST(Saturated, FindsASpotThatWasEmptied) {
    const LayoutProblem problem =
        problem_on(shared({rectangle_ring(4, 4)}), Inside::whole, {l_ring(1, 0.3)}, 7);
    const double epsilon = 0.02 * problem.smallest_inner_radius();
    const Filled filled = fill(problem, epsilon);
    for (std::size_t i = 0; i < filled.darts.size(); ++i) {
        std::vector<Dart> rest = filled.darts;
        rest.erase(rest.begin() + std::ptrdiff_t(i));
        // Without random darts: the search alone must find the room.
        Placements placements(problem);
        for (const Dart& dart : rest)
            placements.place(dart);
        Certificate certificate;
        fill_saturated(problem, {.epsilon = epsilon, .darts = 0}, placements, certificate, {});
        EXPECT_GE(placements.size(), filled.darts.size());
        for (std::size_t k = rest.size(); k < placements.size(); ++k)
            EXPECT_LT(
                (placements.darts()[k].pose.position - filled.darts[i].pose.position).length(),
                2 * problem.largest_radius());
    }
}

TEST(Saturated, SameBytesOnAnyNumberOfThreads) {
    LayoutProblem problem = problem_on(shared({rectangle_ring(14, 12)}), Inside::torus,
                                       {l_ring(1, 0.3), star_ring(0.4, 0.4, 5)}, 8);
    problem.scale = {0.5, 1};
    const auto run = [&](int threads) {
        const ThreadLimit limit(threads);
        return fill(problem, 0.02 * problem.smallest_inner_radius());
    };
    const Filled one = run(1), two = run(2), many = run(7);
    ASSERT_GT(one.darts.size(), 200U);
    EXPECT_EQ(one.certificate.cells, two.certificate.cells);
    for (const Filled& other : {two, many}) {
        ASSERT_EQ(one.darts.size(), other.darts.size());
        for (std::size_t i = 0; i < one.darts.size(); ++i) {
            EXPECT_EQ(one.darts[i].component, other.darts[i].component);
            EXPECT_EQ(one.darts[i].pose.position, other.darts[i].pose.position);
            EXPECT_EQ(one.darts[i].pose.angle, other.darts[i].pose.angle);
            EXPECT_EQ(one.darts[i].pose.scale, other.darts[i].pose.scale);
        }
    }
}

TEST(Saturated, ALimitToTheNumberIsKeptAndNoProof) {
    LayoutProblem problem =
        problem_on(shared({rectangle_ring(8, 8)}), Inside::whole, {l_ring(1, 0.3)}, 9);
    problem.max_count = 20;
    const Filled filled = fill(problem, 0.02 * problem.smallest_inner_radius());
    EXPECT_EQ(filled.darts.size(), 20U);
    EXPECT_FALSE(filled.certificate.is_complete);
}

TEST(Saturated, RefusesAnEpsilonBelowFloatArithmetic) {
    const LayoutProblem problem =
        problem_on(shared({rectangle_ring(8, 8)}), Inside::whole, {l_ring(1, 0.3)}, 9);
    EXPECT_THROW(fill(problem, 1e-7), Error);
}

TEST(TurnPeriod, FindsRotationalSymmetry) {
    EXPECT_NEAR(turn_period(triangulate({rectangle_ring(1, 1)})), pi / 2, 1e-12);
    EXPECT_NEAR(turn_period(triangulate({rectangle_ring(2, 1)})), pi, 1e-12);
    EXPECT_NEAR(turn_period(triangulate({star_ring(1, 0.4, 5)})), 2 * pi / 5, 1e-12);
    EXPECT_NEAR(turn_period(triangulate({l_ring(1, 0.3)})), 2 * pi, 1e-12);
    EXPECT_NEAR(turn_period(triangulate({circle_ring(1, 48)})), 2 * pi / 48, 1e-12);
}

} // namespace

} // namespace scree
