// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/fibres/rest.h"

#include "core/parallel.h"

#include <algorithm>
#include <numeric>

namespace scree::fibres {

namespace {

constexpr int most_steps = 2000;
constexpr int usual_passes = 8;  // of contact that a step may take; more, and it was too long
constexpr int most_passes = 100; // of contact alone before the next step
constexpr float damping = 0.9F;  // share of its speed that a vertex keeps
constexpr float longest = 0.5F;  // step [radii]
constexpr float allowed = 0.2F;  // depth before the next step [radii]
constexpr float still = 0.001F;  // mean step at rest [radii]
// What gravity adds to a step [radii]: as much as fibres that fall allow at first, less and less
// as their weight presses them into each other.
constexpr float first_pull = 0.05F;
constexpr float least_pull = 0.002F;
// Of the stiffness in contact. It falls with the pull, so that fibres bend as much under any.
constexpr float stiffness_to_pull = 0.1F / first_pull;

/// Fibres on their way down.
class Fall {
  public:
    Fall(Rods& rods, const Boundary& boundary, const ContactSettings& settings)
        : rods_(rods), solver_(rods, boundary, settings),
          radius_(static_cast<float>(settings.radius)),
          stiffness_(static_cast<float>(settings.stiffness)),
          speeds_(rods.points.size(), Vec3(0.0F)), ways_(rods.count()) {}

    /// One step and the contact after it; returns the mean way of a vertex [radii].
    double step(RestResult& result) {
        start_ = rods_.points;
        advance();
        int passes = 0;
        const float stiffness = std::min(1.0F, stiffness_ * stiffness_to_pull * pull_);
        for (;; ++passes) {
            const ContactMeasure measure = solver_.measure(&start_);
            if (passes == most_passes || (passes > 0 && measure.within(allowed * radius_)))
                break;
            solver_.apply(passes == 0 ? stiffness : 0);
        }
        result.passes += passes;
        const bool eased = passes <= usual_passes;
        const double way = take_speeds(eased ? 1 : 0.5F) / double(radius_);
        if (!eased)
            ceiling_ *= 0.9F;
        else if (way < 0.1 * double(pull_ / (1 - damping))) // of the speed of free fall
            ceiling_ *= 0.98F;
        ceiling_ = std::max(ceiling_, least_pull);
        pull_ = std::clamp(pull_ * (eased ? 1.03F : 0.7F), least_pull, ceiling_);
        return way;
    }

  private:
    void advance() {
        const std::size_t n = rods_.vertices();
        parallel_for(rods_.points.size(), 4096, [&](std::size_t i) {
            if (rods_.mobility(static_cast<std::uint32_t>(i % n)) == 0)
                return;
            Vec3& v = speeds_[i];
            v = v * damping - Vec3(0, pull_ * radius_, 0);
            const float length = v.length();
            if (length > longest * radius_)
                v *= longest * radius_ / length;
            rods_.points[i] += v;
        });
    }

    /// The way of this step is the speed for the next, but contact makes nothing faster; returns
    /// the mean way [m].
    double take_speeds(float share) {
        const std::size_t n = rods_.vertices();
        parallel_for(rods_.count(), 64, [&](std::size_t f) {
            ways_[f] = 0;
            for (std::size_t i = f * n; i < (f + 1) * n; ++i) {
                const Vec3 way = rods_.points[i] - start_[i];
                const float before = speeds_[i].length();
                const float now = way.length();
                ways_[f] += double(now);
                speeds_[i] = way * (now > before ? share * before / now : share);
            }
        });
        return std::accumulate(ways_.begin(), ways_.end(), 0.0) / double(rods_.points.size());
    }

    Rods& rods_;
    ContactSolver solver_;
    float radius_;
    float stiffness_;
    float pull_ = first_pull;
    float ceiling_ = first_pull; // of the pull
    std::vector<Vec3> start_;    // of the step
    std::vector<Vec3> speeds_;   // [m/step]
    std::vector<double> ways_;   // of each fibre's vertices, summed [m]
};

} // namespace

RestResult come_to_rest(Rods& rods, const Boundary& boundary, const ContactSettings& settings,
                        const Context& context) {
    Fall fall(rods, boundary, settings);
    RestResult result;
    while (!result.at_rest && result.steps < most_steps) {
        context.check_cancel();
        context.report("coming to rest", double(result.steps) / most_steps);
        result.mean_step = fall.step(result);
        ++result.steps;
        result.at_rest = result.mean_step < double(still);
    }
    return result;
}

} // namespace scree::fibres
