// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/exact/disk_set.h"

#include <CGAL/Exact_rational.h>

namespace scree::tests {

namespace {

using Exact = CGAL::Exact_rational;

constexpr double rounding = 1e-12;

double scale_at(const PoissonDiskProblem& problem, const Vec2& point) {
    return problem.scale != nullptr ? problem.scale->at(point) : 1;
}

double direction_at(const PoissonDiskProblem& problem, const Vec2& point) {
    return problem.direction != nullptr ? radians(problem.direction->at(point)) : 0;
}

} // namespace

DiskSet::DiskSet(const PoissonDiskProblem& problem, std::vector<DiskSample> samples)
    : problem_(problem), samples_(std::move(samples)), period_(bounds(*problem.domain).size()) {
    std::vector<double> radii;
    double longest = 0;
    for (const DiskClass& c : problem.classes) {
        radii.push_back(std::sqrt(c.length * c.width));
        longest = std::max({longest, c.length, c.width});
        round_ = round_ && c.length == c.width;
    }
    round_ = round_ && problem.scale == nullptr;
    distances_ = class_distances(radii);
    const double largest =
        problem.scale != nullptr ? problem.scale->over(bounds(*problem.domain)).high : 1;
    reach_ = longest * largest;
    for (const DiskSample& s : samples_)
        jacobians_.push_back(jacobian(problem.classes[s.disk_class], s.angle, s.scale));
    grid_ = std::make_unique<BoxGrid>(boxes(), bounds(*problem.domain), problem.torus);
}

std::vector<Box2> DiskSet::boxes() const {
    std::vector<Box2> out;
    for (const DiskSample& s : samples_)
        out.emplace_back(s.position - Vec2(reach_), s.position + Vec2(reach_));
    return out;
}

DiskSet::Jacobian DiskSet::jacobian(const DiskClass& of, double angle, double scale) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    const double along = 1 / (of.length * scale);
    const double across = 1 / (of.width * scale);
    return {along * c, along * s, -across * s, across * c};
}

double DiskSet::squared_distance(const Jacobian& from, std::uint32_t class_from,
                                 std::uint32_t class_to, const Vec2& offset) const {
    const double x = from[0] * offset.x + from[1] * offset.y;
    const double y = from[2] * offset.x + from[3] * offset.y;
    const double share = distance(class_from, class_from) / distance(class_from, class_to);
    return (x * x + y * y) * share * share;
}

Vec2 DiskSet::wrapped(Vec2 offset) const {
    if (problem_.torus)
        offset -= Vec2(period_.x * std::round(offset.x / period_.x),
                       period_.y * std::round(offset.y / period_.y));
    return offset;
}

double DiskSet::margin(const DiskSample& added) const {
    const Jacobian own = jacobian(problem_.classes[added.disk_class], added.angle, added.scale);
    double least = std::numeric_limits<double>::infinity();
    grid_->visit_at(added.position, [&](std::uint32_t i, const Vec2& shift) {
        const Vec2 offset = samples_[i].position + shift - added.position;
        const std::uint32_t other = samples_[i].disk_class;
        least = std::min({least, squared_distance(own, added.disk_class, other, offset),
                          squared_distance(jacobians_[i], other, added.disk_class, offset)});
    });
    return std::sqrt(least);
}

DiskSample DiskSet::sample(const Vec2& position, std::uint32_t disk_class, double turn) const {
    const Range& range = problem_.classes[disk_class].turn;
    const double angle =
        direction_at(problem_, position) + range.low + turn * (range.high - range.low);
    return {position, disk_class, angle, scale_at(problem_, position)};
}

bool DiskSet::round_conflict(std::size_t i, std::size_t j) const {
    const Vec2& a = samples_[i].position;
    const Vec2& b = samples_[j].position;
    // Multiples of the period are added in rational arithmetic, since the sum is not exact in
    // double.
    const Vec2 turns = problem_.torus ? Vec2(std::round((b.x - a.x) / period_.x),
                                             std::round((b.y - a.y) / period_.y))
                                      : Vec2(0, 0);
    const Exact x = Exact(b.x) - Exact(a.x) - Exact(turns.x) * Exact(period_.x);
    const Exact y = Exact(b.y) - Exact(a.y) - Exact(turns.y) * Exact(period_.y);
    const Exact r(distance(samples_[i].disk_class, samples_[j].disk_class));
    return x * x + y * y < r * r;
}

bool DiskSet::ellipse_conflict(std::size_t i, std::size_t j) const {
    const Vec2 offset = wrapped(samples_[j].position - samples_[i].position);
    const auto in_ellipse = [&](const DiskSample& from, const DiskSample& to) {
        const DiskClass& c = problem_.classes[from.disk_class];
        const long double cosine = std::cos(static_cast<long double>(from.angle));
        const long double sine = std::sin(static_cast<long double>(from.angle));
        const long double x = (cosine * offset.x + sine * offset.y) / (c.length * from.scale);
        const long double y = (cosine * offset.y - sine * offset.x) / (c.width * from.scale);
        const long double share =
            distance(from.disk_class, from.disk_class) / distance(from.disk_class, to.disk_class);
        return std::sqrt(x * x + y * y) * share < 1 - rounding;
    };
    return in_ellipse(samples_[i], samples_[j]) || in_ellipse(samples_[j], samples_[i]);
}

std::size_t DiskSet::conflicts() const {
    const double far = 1.001 * reach_; // with a margin for rounding
    std::size_t count = 0;
    for (std::size_t i = 0; i < samples_.size(); ++i)
        for (std::size_t j = i + 1; j < samples_.size(); ++j) {
            const Vec2 offset = wrapped(samples_[j].position - samples_[i].position);
            if (std::abs(offset.x) > far || std::abs(offset.y) > far)
                continue;
            count += (round_ ? round_conflict(i, j) : ellipse_conflict(i, j)) ? 1 : 0;
        }
    return count;
}

std::size_t DiskSet::misplaced() const {
    std::size_t count = 0;
    for (const DiskSample& s : samples_) {
        const Range& turn = problem_.classes[s.disk_class].turn;
        const double from = direction_at(problem_, s.position) + turn.low;
        const double ahead = s.angle - from - 2 * pi * std::floor((s.angle - from) / (2 * pi));
        const double slack = 1e-9;
        const bool turned = ahead <= turn.high - turn.low + slack || ahead >= 2 * pi - slack;
        const bool scaled = std::abs(s.scale - scale_at(problem_, s.position)) <= slack;
        const bool inside = signed_distance(*problem_.domain, s.position) <= rounding;
        count += turned && scaled && inside ? 0 : 1;
    }
    return count;
}

} // namespace scree::tests
