// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/pile/thesis_method.h"

#include "core/parallel.h"
#include "generators/pile/dependency_levels.h"
#include "generators/pile/golden_section.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace scree {

namespace {

constexpr int iterations = 15; // section 4.3.2.2

/// The components on their way, with what eq. 4.2 is made of.
class Refinement {
  public:
    Refinement(std::span<const PileKind> kinds, std::span<const PileSite> sites, double overlap)
        : kinds_(kinds), sites_(sites), overlap_(overlap), heights_(sites.size(), 0.0) {
        for (const PileKind& kind : kinds) {
            std::vector<Ball> corners;
            for (const Vec3& p : kind.component.prototype.mesh->positions)
                corners.push_back({p - kind.component.origin, 0});
            corners_.emplace_back(std::move(corners));
        }
        find_neighbours();
    }

    const std::vector<std::vector<std::uint32_t>>& neighbours() const { return neighbours_; }

    void refine(std::uint32_t i) {
        const double range = kinds_[sites_[i].kind].range();
        const std::vector<Ball> balls = balls_near(i, {});
        const auto cost = [&](double t) {
            const double overlap = overlap_at(i, t, balls);
            return (overlap > 0 ? overlap + range : 0) + t;
        };
        heights_[i] = golden_section(cost, 0, range, iterations);
    }

    // The first term of eq. 4.1 where the component now is, beside those not `gone` [m].
    double overlap_left(std::uint32_t i, const std::vector<char>& gone) const {
        return overlap_at(i, heights_[i], balls_near(i, gone));
    }

    double height(std::uint32_t i) const { return heights_[i]; }

  private:
    double reach_along_way(std::uint32_t i) const {
        const PileKind& kind = kinds_[sites_[i].kind];
        return kind.component.reach + kind.range();
    }

    void find_neighbours() {
        NeighbourHash hash(kinds_);
        double longest = 0;
        for (const PileKind& kind : kinds_)
            longest = std::max(longest, kind.range());
        for (std::uint32_t i = 0; i < sites_.size(); ++i)
            hash.add(sites_[i].kind, i, sites_[i].position);
        neighbours_.resize(sites_.size());
        parallel_for(sites_.size(), 64, [&](std::size_t n) {
            const auto i = static_cast<std::uint32_t>(n);
            hash.near(sites_[i].position, reach_along_way(i) + longest, [&](std::uint32_t j) {
                const double far = reach_along_way(i) + reach_along_way(j);
                if (i != j && (sites_[i].position - sites_[j].position).length2() < far * far)
                    neighbours_[i].push_back(j);
            });
        });
    }

    // The neighbours' medial balls in the frame of component i at its site.
    std::vector<Ball> balls_near(std::uint32_t i, const std::vector<char>& gone) const {
        const auto reach = static_cast<float>(reach_along_way(i));
        const Pose here = sites_[i].at(0).pose;
        std::vector<Ball> balls;
        for (const std::uint32_t j : neighbours_[i]) {
            if (!gone.empty() && gone[j])
                continue;
            const Placed other = sites_[j].at(heights_[j]);
            const RelativePose there = relative(other.pose, here);
            for (const Ball& ball : kinds_[other.kind].component.balls) {
                const Vec3 centre = there(ball.centre);
                if (centre.length() < reach + ball.radius)
                    balls.push_back({centre, ball.radius});
            }
        }
        return balls;
    }

    // max f(x, T) over the component's vertices at height t, in metres; -T or less: none.
    double overlap_at(std::uint32_t i, double t, const std::vector<Ball>& balls) const {
        const PileKind& kind = kinds_[sites_[i].kind];
        const Vec3 moved =
            sites_[i].normal * sites_[i].world_from_component.transposed() * static_cast<float>(t);
        const auto reach = static_cast<float>(kind.component.reach);
        std::vector<Ball> near;
        for (const Ball& ball : balls)
            if ((ball.centre - moved).length() < reach + ball.radius)
                near.push_back({ball.centre - moved, ball.radius});
        const auto distance = [&](const Vec3& p) {
            float least = std::numeric_limits<float>::max();
            for (const Ball& ball : near)
                least = std::min(least, (p - ball.centre).length() - ball.radius);
            return least;
        };
        return double(corners_[sites_[i].kind].depth_where(distance, 0)) -
               overlap_ * kind.component.radius;
    }

    std::span<const PileKind> kinds_;
    std::span<const PileSite> sites_;
    double overlap_;
    std::vector<BallTree> corners_; // of each kind's mesh
    std::vector<double> heights_;
    std::vector<std::vector<std::uint32_t>> neighbours_;
};

} // namespace

std::vector<PileSite> merge_large_to_small(std::span<const PileKind> kinds,
                                           std::span<const PileSite> sites) {
    std::vector<std::uint32_t> order(kinds.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return kinds[a].component.distribution_radius > kinds[b].component.distribution_radius;
    });
    NeighbourHash larger(kinds);
    std::vector<char> kept(sites.size(), 0);
    for (const std::uint32_t kind : order) {
        std::vector<std::uint32_t> own;
        for (std::uint32_t i = 0; i < sites.size(); ++i) {
            if (sites[i].kind != kind)
                continue;
            bool within = false;
            double most = 0;
            for (const PileKind& other : kinds)
                most = std::max(most, other.distribution_radius());
            larger.near(sites[i].position, most, [&](std::uint32_t j) {
                const double radius = kinds[sites[j].kind].distribution_radius();
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
    std::vector<PileSite> merged;
    for (std::size_t i = 0; i < sites.size(); ++i)
        if (kept[i])
            merged.push_back(sites[i]);
    return merged;
}

void place_by_thesis(Pile& pile, std::span<const PileSite> sites, const ThesisSettings& settings,
                     const Context& context) {
    Refinement refinement(pile.kinds, sites, settings.overlap);
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
                      *settings.removal * pile.kinds[sites[i].kind].component.radius;
    for (std::uint32_t i = 0; i < sites.size(); ++i)
        if (!gone[i])
            pile.add(sites[i].at(refinement.height(i)));
}

} // namespace scree
