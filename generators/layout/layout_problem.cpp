// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/layout/layout_problem.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace scree {

namespace {

std::uint32_t choose_component(const LayoutProblem& problem, std::uint64_t trial, Random& random) {
    const std::size_t count = problem.shapes.size();
    if (problem.selection == Selection::cyclic)
        return static_cast<std::uint32_t>(trial % count);
    const double sum = std::accumulate(problem.weights.begin(), problem.weights.end(), 0.0);
    double left = random.uniform() * sum;
    std::uint32_t last = 0;
    for (std::uint32_t i = 0; i < count; ++i) {
        if (problem.weights[i] <= 0)
            continue;
        last = i;
        left -= problem.weights[i];
        if (left < 0)
            break;
    }
    return last;
}

Dart turned_dart(const LayoutProblem& problem, std::uint64_t trial, Random& random) {
    const std::uint32_t component = choose_component(problem, trial, random);
    const double angle = random.uniform(problem.rotation.low, problem.rotation.high);
    const double scale = random.uniform(problem.scale.low, problem.scale.high);
    return {component, Pose({0, 0}, angle, scale)};
}

/// Extent of all outer points along a direction [m].
double width_along(const Region& region, const Vec2& direction) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Ring& ring : region.rings) {
        for (const Vec2& v : ring) {
            low = std::min(low, direction.dot(v));
            high = std::max(high, direction.dot(v));
        }
    }
    return high - low;
}

} // namespace

double LayoutProblem::largest_radius() const {
    double radius = 0;
    for (const CollisionShape& shape : shapes)
        radius = std::max(radius, shape.radius() * scale.high);
    return radius;
}

double LayoutProblem::clearance() const {
    const Box2& box = domain.box();
    double reach = std::max(
        {std::abs(box.min.x), std::abs(box.min.y), std::abs(box.max.x), std::abs(box.max.y)});
    for (const CollisionShape& shape : shapes)
        reach = std::max(reach, (shape.centre().length() + shape.radius()) * scale.high);
    // Four roundings of 2^-24 (rotation times centre, position) for each of two elements.
    return 8 * 0x1p-24 * reach;
}

double LayoutProblem::smallest_radius() const {
    double radius = std::numeric_limits<double>::infinity();
    for (const CollisionShape& shape : shapes)
        radius = std::min(radius, shape.radius() * scale.low);
    return radius;
}

Dart throw_dart(const LayoutProblem& problem, std::uint64_t trial) {
    Random random(problem.seed, Purpose::layout_dart, trial);
    Dart dart = turned_dart(problem, trial, random);
    dart.pose.position = problem.domain.sample(random);
    return dart;
}

Dart throw_dart_at(const LayoutProblem& problem, std::uint64_t trial, const Vec2& position) {
    Random random(problem.seed, Purpose::layout_dart, trial);
    Dart dart = turned_dart(problem, trial, random);
    dart.pose.position = position;
    return dart;
}

void check_fits(const LayoutProblem& problem, std::size_t component, const std::string& name) {
    const CollisionShape& shape = problem.shapes[component];
    const double scale = problem.scale.low;
    const Vec2 domain_size = problem.domain.box().size();
    // Turning by half a step changes a width by at most the diameter times that angle, so a shape
    // that fits at any angle passes at the nearest step.
    constexpr int steps = 2048;
    const double step = (problem.rotation.high - problem.rotation.low) / steps;
    const double slack = 2 * shape.radius() * scale * std::abs(step) / 2;
    bool fits = false;
    for (int i = 0; i <= steps && !fits; ++i) {
        const double angle = problem.rotation.low + step * i;
        // The extent of the turned shape along x is its own extent along x turned back.
        const double width = width_along(shape.outline(), rotate({1, 0}, -angle)) * scale;
        const double depth = width_along(shape.outline(), rotate({0, 1}, -angle)) * scale;
        fits = width <= domain_size.x + slack && depth <= domain_size.y + slack;
    }
    fits = fits && shape.area() * scale * scale <= area(problem.domain.region());
    if (fits)
        return;
    const Vec2 size = bounds(shape.outline()).size() * scale;
    throw Error(fmt::format("the region of {}, {:.4g} x {:.4g} m{}, does not fit the domain, "
                            "{:.4g} x {:.4g} m",
                            name, size.x, size.y,
                            problem.scale.low < problem.scale.high ? " at the smallest scale" : "",
                            domain_size.x, domain_size.y));
}

} // namespace scree
