// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/pile/thesis_method.h"

#include "core/parallel.h"
#include "geometry/bodies/corner_depth.h"
#include "geometry/bodies/dependency_levels.h"
#include "geometry/bodies/golden_section.h"

#include <algorithm>
#include <numeric>

namespace scree {

namespace {

constexpr int iterations = 15;     // section 4.3.2.2
constexpr double grid_step = 0.15; // in radii; a finer grid takes longer to make than it saves

/// A medial ball of a neighbour, in the frame of the component at its site. No corner of the
/// component is deeper in it than `bound` [m] when the component is at `height` [m]; a depth
/// changes no faster than the height.
struct NearBall {
    Ball ball;
    double height = 0;
    float bound = 0;
};

/// The components and their heights so far, with what eq. 4.2 is computed from.
class Refinement {
  public:
    Refinement(std::span<const PileKind> kinds, std::span<const BodySite> sites, double overlap)
        : kinds_(kinds), sites_(sites), overlap_(overlap), heights_(sites.size(), 0.0) {
        double largest = 0;
        for (const PileKind& kind : kinds)
            for (const Ball& ball : kind.body->balls)
                largest = std::max(largest, double(ball.radius));
        for (const PileKind& kind : kinds) {
            std::vector<Vec3> corners;
            for (const Vec3& p : kind.body->mesh->positions)
                corners.push_back(p - kind.body->origin);
            corners_.emplace_back(corners, grid_step * kind.body->radius, largest);
            doubt_ = std::max(doubt_, 1e-5F * static_cast<float>(kind.body->reach + kind.range()));
        }
        find_neighbours();
    }

    const std::vector<std::vector<std::uint32_t>>& neighbours() const { return neighbours_; }

    void refine(std::uint32_t i) {
        const double range = kinds_[sites_[i].body].range();
        std::vector<NearBall> balls = balls_near(i, 0, range, {});
        const auto cost = [&](double t) {
            const double overlap = overlap_at(i, t, balls);
            return (overlap > 0 ? overlap + range : 0) + t;
        };
        heights_[i] = golden_section(cost, 0, range, iterations);
    }

    // The first term of eq. 4.1 [m] for the component where it is now, with those that are not
    // `gone`.
    double overlap_left(std::uint32_t i, const std::vector<char>& gone) const {
        std::vector<NearBall> balls = balls_near(i, heights_[i], heights_[i], gone);
        return overlap_at(i, heights_[i], balls);
    }

    double height(std::uint32_t i) const { return heights_[i]; }

  private:
    Imath::V3d mid_way(std::uint32_t i) const {
        return sites_[i].position +
               Imath::V3d(sites_[i].normal) * (kinds_[sites_[i].body].range() / 2);
    }

    // How far from the middle of its way component i may reach.
    double reach_along_way(std::uint32_t i) const {
        const PileKind& kind = kinds_[sites_[i].body];
        return kind.body->reach + kind.range() / 2;
    }

    void find_neighbours() {
        NeighbourHash hash(bodies_of(kinds_));
        double longest = 0;
        for (const PileKind& kind : kinds_)
            longest = std::max(longest, kind.range());
        for (std::uint32_t i = 0; i < sites_.size(); ++i)
            hash.add(sites_[i].body, i, mid_way(i));
        neighbours_.resize(sites_.size());
        parallel_for(sites_.size(), 64, [&](std::size_t n) {
            const auto i = static_cast<std::uint32_t>(n);
            hash.near(mid_way(i), reach_along_way(i) + longest / 2, [&](std::uint32_t j) {
                const double far = reach_along_way(i) + reach_along_way(j);
                if (i != j && (mid_way(i) - mid_way(j)).length2() < far * far)
                    neighbours_[i].push_back(j);
            });
        });
    }

    float allowed(std::uint32_t i) const {
        return static_cast<float>(overlap_ * kinds_[sites_[i].body].body->radius);
    }

    // By what component i has moved at height t, in its own frame [m].
    Vec3 moved(std::uint32_t i, double t) const {
        return sites_[i].normal * sites_[i].world_from_body.transposed() * static_cast<float>(t);
    }

    // The neighbours' medial balls in which component i may be deeper than T at heights from `low`
    // to `high`, those with the greatest bounds first.
    std::vector<NearBall> balls_near(std::uint32_t i, double low, double high,
                                     const std::vector<char>& gone) const {
        const PileKind& kind = kinds_[sites_[i].body];
        const CornerDepth& corners = corners_[sites_[i].body];
        const double middle = (low + high) / 2;
        const Vec3 shift = moved(i, middle);
        const float floor = allowed(i) - doubt_ - static_cast<float>((high - low) / 2);
        const float reach = static_cast<float>(kind.body->reach) - floor;
        const Pose here = sites_[i].at(0).pose;
        std::vector<NearBall> balls;
        for (const std::uint32_t j : neighbours_[i]) {
            if (!gone.empty() && gone[j])
                continue;
            const PlacedBody other = sites_[j].at(heights_[j]);
            const Body& body = *kinds_[other.body].body;
            const RelativePose there = relative(other.pose, here);
            const float far = std::max(reach, 0.0F) + static_cast<float>(body.reach);
            if ((there.offset - shift).length2() > far * far)
                continue;
            for (const Ball& ball : body.balls) {
                const Ball own{there(ball.centre), ball.radius};
                const float bound = corners.bound({own.centre - shift, own.radius});
                if (bound > floor)
                    balls.push_back({own, middle, bound});
            }
        }
        std::sort(balls.begin(), balls.end(),
                  [](const NearBall& a, const NearBall& b) { return a.bound > b.bound; });
        return balls;
    }

    // max f(x, T) over the component's vertices at height t [m], but at least 0: by eq. 4.1 less is
    // no overlap. Balls whose bounds are below the deepest so far are skipped; to skip more, the
    // one found deepest is moved to the front for the next call.
    double overlap_at(std::uint32_t i, double t, std::vector<NearBall>& balls) const {
        const CornerDepth& corners = corners_[sites_[i].body];
        const Vec3 shift = moved(i, t);
        const float least = allowed(i);
        float deepest = least;
        std::size_t at = 0;
        for (std::size_t b = 0; b < balls.size(); ++b) {
            NearBall& near = balls[b];
            const auto way = static_cast<float>(std::abs(t - near.height));
            if (near.bound + way + doubt_ <= deepest)
                continue;
            const Ball ball{near.ball.centre - shift, near.ball.radius};
            near.height = t;
            near.bound = corners.bound(ball);
            if (near.bound + doubt_ <= deepest)
                continue;
            near.bound = corners.depth(ball, deepest);
            if (near.bound > deepest) {
                deepest = near.bound;
                at = b;
            }
        }
        if (at > 0)
            std::swap(balls[0], balls[at]);
        return double(deepest) - double(least);
    }

    std::span<const PileKind> kinds_;
    std::span<const BodySite> sites_;
    double overlap_;
    std::vector<CornerDepth> corners_; // of each kind's mesh
    float doubt_ = 0;                  // more than the rounding error of a depth [m]
    std::vector<double> heights_;
    std::vector<std::vector<std::uint32_t>> neighbours_;
};

} // namespace

std::vector<BodySite> merge_large_to_small(std::span<const PileKind> kinds,
                                           std::span<const BodySite> sites) {
    std::vector<std::uint32_t> order(kinds.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return kinds[a].unit_radius > kinds[b].unit_radius;
    });
    double largest = 0;
    for (const PileKind& kind : kinds)
        largest = std::max(largest, kind.distribution_radius());
    NeighbourHash larger(bodies_of(kinds));
    std::vector<char> kept(sites.size(), 0);
    for (const std::uint32_t kind : order) {
        std::vector<std::uint32_t> own;
        for (std::uint32_t i = 0; i < sites.size(); ++i) {
            if (sites[i].body != kind)
                continue;
            bool within = false;
            larger.near(sites[i].position, largest, [&](std::uint32_t j) {
                const double radius = kinds[sites[j].body].distribution_radius();
                within =
                    within || (sites[j].position - sites[i].position).length2() <= radius * radius;
            });
            if (within)
                continue;
            kept[i] = 1;
            own.push_back(i);
        }
        for (const std::uint32_t i : own)
            larger.add(kind, i, sites[i].position);
    }
    std::vector<BodySite> merged;
    for (std::size_t i = 0; i < sites.size(); ++i)
        if (kept[i])
            merged.push_back(sites[i]);
    return merged;
}

void place_by_thesis(PlacedBodies& pile, std::span<const PileKind> kinds,
                     std::span<const BodySite> sites, const ThesisSettings& settings,
                     const Context& context) {
    Refinement refinement(kinds, sites, settings.overlap);
    const auto levels = dependency_levels(refinement.neighbours());
    for (std::size_t l = 0; l < levels.size(); ++l) {
        context.check_cancel();
        context.report("refine", double(l) / double(levels.size()));
        parallel_for(levels[l].size(), 1, [&](std::size_t n) { refinement.refine(levels[l][n]); });
    }
    std::vector<char> gone(sites.size(), 0);
    if (settings.removal)
        for (std::uint32_t i = 0; i < sites.size(); ++i)
            gone[i] = refinement.overlap_left(i, gone) >
                      *settings.removal * kinds[sites[i].body].body->radius;
    for (std::uint32_t i = 0; i < sites.size(); ++i)
        if (!gone[i])
            pile.add(sites[i].at(refinement.height(i)));
}

} // namespace scree
