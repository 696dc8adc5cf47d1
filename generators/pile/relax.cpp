// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/pile/relax.h"

#include "core/parallel.h"
#include "generators/pile/relax_sites.h"
#include "geometry/bodies/push.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <limits>

namespace scree {

namespace {

constexpr double grid_step = 0.5;   // of the target's distance, in twice the least unit radius
constexpr double contact = 0.004;   // the depth that pushing aims at, in radii
constexpr double most_depth = 0.01; // the depth that is accepted: probes are exact to 1%
constexpr double margin = 0.25;     // up to which gap pairs are near each other, in radii
constexpr int sweeps_with_same_pairs = 5; // until near pairs are looked for again
constexpr int most_colours = 64;          // as many as a word has bits

struct Pair {
    std::uint32_t a, b;
};

class Relaxation {
  public:
    Relaxation(const Mesh& target, const PileTurns& turns, const RelaxSettings& settings)
        : kinds_(turns.kinds), settings_(settings),
          target_(target, grid_step * least_size(turns.kinds)) {
        for (const PileKind& kind : kinds_)
            masses_.push_back(mass_properties(*kind.body));
    }

    Relaxed run(const Mesh& target, const PileTurns& turns, const Context& context) {
        Relaxed relaxed;
        relaxed.start = strewn(target, target_, turns, masses_, settings_, context);
        all_ = relaxed.start;
        for (const PlacedBody& placed : all_)
            bodies_.push_back({kinds_[placed.body].body.get(), &masses_[placed.body], placed.pose});
        for (int i = 0; i < settings_.iterations; ++i) {
            context.check_cancel();
            context.report("relax", double(i) / settings_.iterations);
            if (i % sweeps_with_same_pairs == 0)
                colour(near_pairs());
            const bool still = !sweep();
            if (still && i % sweeps_with_same_pairs == 0)
                break;
        }
        relaxed.all = left();
        return relaxed;
    }

  private:
    static double least_size(std::span<const PileKind> kinds) {
        double least = std::numeric_limits<double>::max();
        for (const PileKind& kind : kinds)
            least = std::min(least, 2 * kind.unit_radius);
        return least;
    }

    double allowed(const Pair& pair, double depth) const {
        return (settings_.overlap + depth) *
               std::min(bodies_[pair.a].body->radius, bodies_[pair.b].body->radius);
    }

    /// Sorted by the numbers of their bodies.
    std::vector<Pair> near_pairs() const {
        NeighbourHash hash(bodies_of(kinds_));
        for (std::uint32_t i = 0; i < bodies_.size(); ++i)
            hash.add(all_[i].body, i, bodies_[i].pose.centre);
        std::vector<std::vector<std::uint32_t>> others(bodies_.size());
        parallel_for(bodies_.size(), 16, [&](std::size_t i) {
            const MovingBody& body = bodies_[i];
            const double near = body.body->reach + margin * body.body->radius;
            hash.near(body.pose.centre, near, [&](std::uint32_t j) {
                if (j <= i)
                    return;
                const RelativePose there = relative(body.pose, bodies_[j].pose);
                if (double(bodies_[j].body->distance.at(there.offset)) < near)
                    others[i].push_back(j);
            });
            std::sort(others[i].begin(), others[i].end());
        });
        std::vector<Pair> pairs;
        for (std::uint32_t i = 0; i < others.size(); ++i)
            for (const std::uint32_t j : others[i])
                pairs.push_back({i, j});
        return pairs;
    }

    /// Gives each pair the first colour that no other pair of its bodies has. The pairs for which
    /// no colour is left are solved after all others, one by one.
    void colour(const std::vector<Pair>& pairs) {
        colours_.assign(most_colours, {});
        rest_.clear();
        std::vector<std::uint64_t> used(bodies_.size(), 0);
        for (const Pair& pair : pairs) {
            const int free = std::countr_one(used[pair.a] | used[pair.b]);
            if (free == most_colours) {
                rest_.push_back(pair);
                continue;
            }
            used[pair.a] |= std::uint64_t{1} << free;
            used[pair.b] |= std::uint64_t{1} << free;
            colours_[std::size_t(free)].push_back(pair);
        }
    }

    /// Pushes all pairs apart once; returns whether any was too deep before.
    bool sweep() {
        std::atomic<bool> deep = false;
        const auto solve = [&](const Pair& pair) {
            const double depth =
                push_apart(bodies_[pair.a], bodies_[pair.b], allowed(pair, contact));
            if (depth > allowed(pair, most_depth))
                deep.store(true, std::memory_order_relaxed);
        };
        for (const std::vector<Pair>& pairs : colours_)
            parallel_for(pairs.size(), 32, [&](std::size_t i) { solve(pairs[i]); });
        for (const Pair& pair : rest_)
            solve(pair);
        parallel_for(bodies_.size(), 64, [&](std::size_t i) { hold(i); });
        return deep;
    }

    /// Moves the centre back to the space in which components were strewn, if it has left it.
    void hold(std::size_t i) {
        Vec3 gradient;
        Imath::V3d& centre = bodies_[i].pose.centre;
        const double height = double(target_.at(Vec3(centre), gradient));
        const double high = settings_.solid ? 0 : kinds_[all_[i].body].range();
        const double low = settings_.solid ? std::numeric_limits<double>::lowest() : 0;
        const double held = std::clamp(height, low, high);
        if (held != height && gradient.length() > 0)
            centre += Imath::V3d(gradient.normalized()) * (held - height);
    }

    /// Of each pair that is still too deep, the deepest first, removes the one that is in more such
    /// pairs; returns the others.
    std::vector<PlacedBody> left() {
        const std::vector<Pair> pairs = near_pairs();
        std::vector<double> depths(pairs.size(), 0);
        parallel_for(pairs.size(), 32, [&](std::size_t i) {
            const MovingBody& a = bodies_[pairs[i].a];
            const MovingBody& b = bodies_[pairs[i].b];
            const double most = allowed(pairs[i], most_depth);
            const double depth = std::max(depth_in(a, b, most), depth_in(b, a, most));
            if (depth > most)
                depths[i] = depth;
        });
        std::vector<std::uint32_t> deep;
        std::vector<int> conflicts(bodies_.size(), 0);
        for (std::uint32_t i = 0; i < pairs.size(); ++i)
            if (depths[i] > 0) {
                deep.push_back(i);
                ++conflicts[pairs[i].a];
                ++conflicts[pairs[i].b];
            }
        std::stable_sort(deep.begin(), deep.end(),
                         [&](std::uint32_t i, std::uint32_t j) { return depths[i] > depths[j]; });
        std::vector<bool> gone(bodies_.size(), false);
        for (const std::uint32_t i : deep) {
            const auto [a, b] = pairs[i];
            if (!gone[a] && !gone[b])
                gone[conflicts[a] > conflicts[b] ? a : b] = true;
        }
        std::vector<PlacedBody> left;
        for (std::size_t i = 0; i < bodies_.size(); ++i)
            if (!gone[i])
                left.push_back(placed(i));
        return left;
    }

    static double depth_in(const MovingBody& a, const MovingBody& b, double floor) {
        return double(a.body->probe.depth_in(b.body->distance, relative(a.pose, b.pose),
                                             static_cast<float>(floor)));
    }

    PlacedBody placed(std::size_t i) const {
        Vec3 gradient;
        const Pose& pose = bodies_[i].pose;
        const double height = double(target_.at(Vec3(pose.centre), gradient));
        const Vec3 normal = gradient.length() > 0 ? gradient.normalized() : all_[i].normal;
        return {all_[i].body, pose, normal, height};
    }

    std::span<const PileKind> kinds_;
    RelaxSettings settings_;
    SignedDistanceGrid target_;
    std::vector<MassProperties> masses_; // by kind
    std::vector<PlacedBody> all_;        // as strewn
    std::vector<MovingBody> bodies_;
    std::vector<std::vector<Pair>> colours_;
    std::vector<Pair> rest_; // without a colour
};

} // namespace

Relaxed relax(const Mesh& target, const PileTurns& turns, const RelaxSettings& settings,
              const Context& context) {
    return Relaxation(target, turns, settings).run(target, turns, context);
}

} // namespace scree
