// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/figures/layout_problem.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace scree {

namespace {

/// The random numbers of a trial, apart from its position.
struct Draw {
    double choice = 0; // uniform in [0, 1)
    double turn = 0;   // [rad]
    double scale = 1;
};

Draw draw(const LayoutProblem& problem, Random& random) {
    Draw result;
    if (problem.selection == Selection::weighted)
        result.choice = random.uniform();
    result.turn = random.uniform(problem.rotation.low, problem.rotation.high);
    result.scale = random.uniform(problem.scale.low, problem.scale.high);
    return result;
}

/// Selects among the components that may lie there; `nobody` where there are none.
std::optional<std::uint32_t> choose_component(const LayoutProblem& problem, std::uint64_t trial,
                                              double choice, const Vec2& position) {
    const auto count = static_cast<std::uint32_t>(problem.shapes.size());
    if (!problem.fields.classes && problem.selection == Selection::cyclic)
        return static_cast<std::uint32_t>(trial % count);
    const auto weight = [&](std::uint32_t i) {
        if (!problem.has_class(i, position))
            return 0.0;
        return problem.selection == Selection::weighted ? problem.weights[i] : 1.0;
    };
    double sum = 0;
    for (std::uint32_t i = 0; i < count; ++i)
        sum += weight(i);
    double left = problem.selection == Selection::weighted
                      ? choice * sum
                      : std::fmod(static_cast<double>(trial), sum);
    std::optional<std::uint32_t> chosen;
    for (std::uint32_t i = 0; i < count; ++i) {
        if (weight(i) <= 0)
            continue;
        chosen = i;
        left -= weight(i);
        if (left < 0)
            break;
    }
    return chosen;
}

std::optional<Dart> dart_of(const LayoutProblem& problem, std::uint64_t trial, const Draw& draw,
                            const Vec2& position) {
    const auto component = choose_component(problem, trial, draw.choice, position);
    if (!component)
        return std::nullopt;
    return problem.dart(*component, position, draw.turn, draw.scale);
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
        radius = std::max(radius, shape.radius());
    return radius * scale.high * scale_over(domain.box()).high;
}

double LayoutProblem::smallest_radius() const {
    double radius = std::numeric_limits<double>::infinity();
    for (const CollisionShape& shape : shapes)
        radius = std::min(radius, shape.radius());
    return radius * scale.low * scale_over(domain.box()).low;
}

double LayoutProblem::smallest_inner_radius() const {
    double radius = std::numeric_limits<double>::infinity();
    for (const CollisionShape& shape : shapes)
        radius = std::min(radius, shape.inner_radius());
    return radius * scale.low * scale_over(domain.box()).low;
}

double LayoutProblem::largest_margin() const {
    double margin = 0;
    for (const double m : margins)
        margin = std::max(margin, m);
    return margin * scale.high * scale_over(domain.box()).high * density_over(domain.box()).high;
}

Range LayoutProblem::direction_over(const Box2& box) const {
    if (!fields.direction)
        return {0, 0};
    const Range range = fields.direction->over(box);
    return {radians(range.low), radians(range.high)};
}

Range LayoutProblem::scale_over(const Box2& box) const {
    return fields.scale ? fields.scale->over(box) : Range{1, 1};
}

Range LayoutProblem::density_over(const Box2& box) const {
    return fields.density ? fields.density->over(box) : Range{1, 1};
}

bool LayoutProblem::has_class(std::uint32_t component, const Vec2& point) const {
    return !fields.classes || std::lround(fields.classes->at(point)) == classes[component];
}

Dart LayoutProblem::dart(std::uint32_t component, const Vec2& position, double turn,
                         double size) const {
    const double direction = fields.direction ? radians(fields.direction->at(position)) : 0;
    const double factor = fields.scale ? fields.scale->at(position) : 1;
    const double density = fields.density ? fields.density->at(position) : 1;
    const double margin = margins.empty() ? 0 : margins[component] * size * factor * density;
    return {component, FigurePose(position, direction + turn, size * factor), margin};
}

double LayoutProblem::clearance() const {
    const Box2& box = domain.box();
    double reach = std::max(
        {std::abs(box.min.x), std::abs(box.min.y), std::abs(box.max.x), std::abs(box.max.y)});
    const double largest = scale_over(box).high;
    for (const CollisionShape& shape : shapes)
        reach = std::max(reach, (shape.centre().length() + shape.radius()) * scale.high * largest);
    // Four roundings of 2^-24 (rotation times centre, position) for each of two elements.
    return 8 * 0x1p-24 * reach;
}

std::optional<Dart> throw_dart(const LayoutProblem& problem, std::uint64_t trial) {
    Random random(problem.seed, Purpose::layout_dart, trial);
    const Draw drawn = draw(problem, random);
    return dart_of(problem, trial, drawn, problem.domain.sample(random));
}

std::optional<Dart> throw_dart_at(const LayoutProblem& problem, std::uint64_t trial,
                                  const Vec2& position) {
    Random random(problem.seed, Purpose::layout_dart, trial);
    return throw_dart_at(problem, trial, position, random);
}

std::optional<Dart> throw_dart_at(const LayoutProblem& problem, std::uint64_t trial,
                                  const Vec2& position, Random& random) {
    return dart_of(problem, trial, draw(problem, random), position);
}

void check_fits(const LayoutProblem& problem, std::size_t component, const std::string& name) {
    const CollisionShape& shape = problem.shapes[component];
    const double scale = problem.scale.low * problem.scale_over(problem.domain.box()).low;
    const Vec2 domain_size = problem.domain.box().size();
    // Turning by half a step changes a width by at most the diameter times that angle, so a shape
    // that fits at any angle passes at the nearest step.
    constexpr int steps = 2048;
    const double step = (problem.rotation.high - problem.rotation.low) / steps;
    const double slack = 2 * shape.radius() * scale * std::abs(step) / 2;
    bool fits = false;
    for (int i = 0; i <= steps && !fits; ++i) {
        const double angle = problem.rotation.low + step * i;
        // The extent of the turned shape along x is that of the unturned shape along x turned back.
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
