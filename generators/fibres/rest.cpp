// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/fibres/rest.h"

#include "core/parallel.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace scree::fibres {

namespace {

constexpr int most_steps = 2000;
constexpr int usual_passes = 8;  // of contact that a step may take; more, and it was too long
constexpr int most_passes = 100; // of contact after a step
constexpr int late_passes = 3;   // the same, when gravity is at its least
constexpr float damping = 0.9F;  // share of its speed that a vertex keeps
constexpr float longest = 0.5F;  // step [radii]
constexpr float deepest = 0.4F;  // of any fibre before the next step [radii]
constexpr float held = 0.2F;     // depth of a fibre that contact alone moves [radii]
constexpr float stiffest = 0.3F; // share of their bending that wires spring back by in a step
constexpr float still = 0.001F;  // mean step at rest [radii]
// What gravity adds to a step [radii]: as much as fibres that fall allow at first, less and less
// as their weight presses them into each other.
constexpr float first_pull = 0.05F;
constexpr float least_pull = 0.002F;

/// Fibres on their way down.
class Fall {
  public:
    Fall(Rods& rods, const Boundary& boundary, const ContactSettings& settings)
        : rods_(rods), solver_(rods, boundary, settings),
          radius_(static_cast<float>(settings.radius)),
          stiffness_(static_cast<float>(std::pow(settings.stiffness, 4))),
          speeds_(rods.points.size(), Vec3(0.0F)), ways_(rods.count()) {}

    /// One step and the contact after it; returns the mean way of a vertex [radii].
    double step(RestResult& result) {
        solver_.begin_step();
        advance();
        int passes = 0;
        const int most = pull_ > least_pull ? most_passes : late_passes;
        // In proportion to the pull, so that fibres bend as much under any.
        const float stiffness = std::min(stiffest, stiffness_ * pull_ / least_pull);
        for (;; ++passes) {
            const ContactMeasure measure = solver_.measure();
            if (passes == most || (passes > 0 && measure.within(deepest * radius_)))
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
        const Vec3 pull(0, pull_ * radius_, 0);
        parallel_for(rods_.count(), 64, [&](std::size_t f) {
            const bool waits = solver_.depth_of(f) > held * radius_;
            for (std::uint32_t v = 0; v < n; ++v) {
                const std::size_t i = f * n + v;
                if (waits || rods_.mobility(v) == 0) {
                    speeds_[i] = Vec3(0.0F);
                    continue;
                }
                speeds_[i] = speeds_[i] * damping - pull;
                const float length = speeds_[i].length();
                if (length > longest * radius_)
                    speeds_[i] *= longest * radius_ / length;
                rods_.points[i] += speeds_[i];
            }
        });
    }

    /// The way of this step is the speed for the next, but contact makes nothing faster; returns
    /// the mean way [m].
    double take_speeds(float share) {
        const std::size_t n = rods_.vertices();
        const std::vector<Vec3>& start = solver_.start();
        parallel_for(rods_.count(), 64, [&](std::size_t f) {
            ways_[f] = 0;
            for (std::size_t i = f * n; i < (f + 1) * n; ++i) {
                const Vec3 way = rods_.points[i] - start[i];
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
    float stiffness_; // from noodles to wire: to the fourth power, as that of a rod by its radius
    float pull_ = first_pull;
    float ceiling_ = first_pull; // of the pull
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
