// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sampling/disk_metric.h"

namespace scree {

DiskMetric::DiskMetric(const PoissonDiskProblem& problem)
    : classes_(problem.classes), direction_(problem.direction), scale_(problem.scale) {
    const std::size_t n = classes_.size();
    std::vector<double> sizes;
    for (const DiskClass& c : classes_)
        sizes.push_back(std::sqrt(c.length * c.width));
    const std::vector<double> distances = class_distances(sizes);
    limits_.resize(n * n);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) {
            const double ratio = distances[i * n + j] / sizes[i];
            limits_[i * n + j] = i == j ? 1 : ratio * ratio;
        }
    for (const double limit : limits_)
        limit_roots_.push_back(std::sqrt(limit));
    longest_ = shortest_ = classes_[0].length;
    for (const DiskClass& c : classes_) {
        longest_ = std::max({longest_, c.length, c.width});
        shortest_ = std::min({shortest_, c.length, c.width});
    }
    least_distance_ = *std::min_element(distances.begin(), distances.end());
}

QuadraticForm DiskMetric::form(std::uint32_t disk_class, double angle, double scale) const {
    const DiskClass& c = classes_[disk_class];
    const double along = 1 / (c.length * c.length * scale * scale);
    const double across = 1 / (c.width * c.width * scale * scale);
    const double cosine = std::cos(angle);
    const double sine = std::sin(angle);
    return {along * cosine * cosine + across * sine * sine, (along - across) * cosine * sine,
            along * sine * sine + across * cosine * cosine};
}

double DiskMetric::angle_at(const Vec2& p) const {
    return direction_ ? radians(direction_->at(p)) : 0;
}

double DiskMetric::scale_at(const Vec2& p) const { return scale_ ? scale_->at(p) : 1; }

DiskMetric::Bounds DiskMetric::over(const Box2& box) const {
    Bounds bounds;
    if (direction_) {
        const Range range = direction_->over(box);
        bounds.angle = radians((range.low + range.high) / 2);
        bounds.half_range = std::min(radians((range.high - range.low) / 2), pi);
    }
    bounds.scale = scale_over(box);
    return bounds;
}

Range DiskMetric::scale_over(const Box2& box) const {
    return scale_ ? scale_->over(box) : Range{1, 1};
}

// With u along and v across the middle angle, an ellipse turned by up to h has
// (u cos + v sin)^2 / l^2 + (v cos - u sin)^2 / w^2
//   <= (|u| + |v| s)^2 / l^2 + (|v| + |u| s)^2 / w^2,  s = sin h,
// and (x + y)^2 <= (1 + a) x^2 + (1 + 1/a) y^2 for any a > 0: with a = s w / l in the first and
// a = s l / w in the second term both coefficients grow by the same share to first order.
QuadraticForm DiskMetric::common_form(std::uint32_t disk_class, const Bounds& bounds) const {
    const DiskClass& c = classes_[disk_class];
    const double scale = bounds.scale.low;
    if (bounds.half_range == 0)
        return form(disk_class, bounds.angle, scale);
    const bool is_long = c.length >= c.width;
    const double l = (is_long ? c.length : c.width) * scale;
    const double w = (is_long ? c.width : c.length) * scale;
    const double ratio = l / w;
    const double s = bounds.half_range < pi / 2 ? std::sin(bounds.half_range) : 1;
    const double linear = s * ratio + s / ratio;
    const double along = (1 + linear + s * s * ratio * ratio) / (l * l);
    const double across = (1 + linear + s * s / (ratio * ratio)) / (w * w);
    if (along >= 1 / (w * w)) // the disk inside is the larger one
        return {1 / (w * w), 0, 1 / (w * w)};
    const double angle = is_long ? bounds.angle : bounds.angle + pi / 2;
    const double cosine = std::cos(angle);
    const double sine = std::sin(angle);
    return {along * cosine * cosine + across * sine * sine, (along - across) * cosine * sine,
            along * sine * sine + across * cosine * cosine};
}

} // namespace scree
