// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/layout/gap_field.h"
#include "generators/layout/method.h"

#include <algorithm>

namespace scree {

namespace {

/// Step 1: elements at Poisson-disk points, whose circles hold the largest element at any angle.
void place_sparsely(const LayoutProblem& problem, std::uint64_t cancellations,
                    Placements& placements, MethodCounts& counts) {
    const double clearance = problem.clearance();
    const double distance = 2 * (problem.largest_radius() + problem.largest_margin()) + clearance;
    std::uint64_t in_a_row = 0;
    for (std::uint64_t i = 0; in_a_row < cancellations && !placements.full(); ++i) {
        Random random(problem.seed, Purpose::layout_sparse, i);
        const std::optional<Dart> dart =
            throw_dart_at(problem, counts.trials, problem.domain.sample(random));
        const bool is_placed = dart && placements.keeps_distance(dart->pose.position, distance) &&
                               problem.domain.accepts(problem.shapes[dart->component], dart->pose,
                                                      clearance + dart->margin);
        ++counts.trials;
        if (is_placed) {
            placements.place(*dart);
            in_a_row = 0;
        } else {
            ++counts.cancellations;
            ++in_a_row;
        }
    }
}

/// `count` of the points in random order, or all when there are fewer.
void choose(std::vector<Vec2>& points, std::size_t count, Random& random) {
    count = std::min(count, points.size());
    for (std::size_t i = 0; i < count; ++i)
        std::swap(points[i],
                  points[i + random.below(static_cast<std::uint32_t>(points.size() - i))]);
    points.resize(count);
}

} // namespace

MethodCounts fill_gap(const LayoutProblem& problem, const FillGapSettings& settings,
                      Placements& placements, const Context& context) {
    MethodCounts counts;
    place_sparsely(problem, settings.cancellations, placements, counts);

    GapField field(problem.domain, settings.resolution, context.device);
    std::size_t in_field = 0;
    std::uint64_t in_a_row = 0;
    for (std::uint64_t round = 0; in_a_row < settings.cancellations && !placements.full();
         ++round) {
        context.check_cancel();
        context.report("filling gaps", double(in_a_row) / double(settings.cancellations));
        for (; in_field < placements.size(); ++in_field) {
            const Dart& dart = placements.darts()[in_field];
            field.occupy(problem.shapes[dart.component].outline(), dart.pose);
        }
        std::vector<Vec2> points = field.candidates(settings.exponent, problem.seed, round);
        if (points.empty())
            break;
        Random random(problem.seed, Purpose::layout_choice, round);
        choose(points, settings.candidates, random);
        for (const Vec2& point : points) {
            if (in_a_row >= settings.cancellations || placements.full())
                break;
            const std::optional<Dart> dart = throw_dart_at(problem, counts.trials++, point);
            if (dart && placements.try_place(*dart)) {
                in_a_row = 0;
            } else {
                ++counts.cancellations;
                ++in_a_row;
            }
        }
    }
    return counts;
}

} // namespace scree
