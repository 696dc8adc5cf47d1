// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/figures/domain_test.h"

#include <algorithm>
#include <limits>

namespace scree {

namespace {

bool apart_along(const Vec2& axis, const Vec2& a0, const Vec2& a1, const Vec2& b0, const Vec2& b1,
                 double tolerance) {
    const auto [a_low, a_high] = std::minmax({axis.dot(a0), axis.dot(a1)});
    const auto [b_low, b_high] = std::minmax({axis.dot(b0), axis.dot(b1)});
    return a_low > b_high + tolerance || b_low > a_high + tolerance;
}

bool segments_apart(const Vec2& a0, const Vec2& a1, const Vec2& b0, const Vec2& b1,
                    double tolerance) {
    const Vec2 a = (a1 - a0).normalized(), b = (b1 - b0).normalized();
    return apart_along({a.y, -a.x}, a0, a1, b0, b1, tolerance) ||
           apart_along({b.y, -b.x}, a0, a1, b0, b1, tolerance) ||
           apart_along(a, a0, a1, b0, b1, tolerance) || apart_along(b, a0, a1, b0, b1, tolerance);
}

} // namespace

DomainTest::DomainTest(std::shared_ptr<const Region> domain, Inside inside)
    : domain_(std::move(domain)), inside_(inside), box_(bounds(*domain_)), period_(box_.size()) {
    if (!is_torus())
        period_ = Vec2(std::numeric_limits<double>::infinity());
    tolerance_ = 1e-12 * (box_.size().length() + box_.center().length());
    double sum = 0;
    for (const auto& t : domain_->triangles) {
        const Vec2& a = domain_->vertices[t[0]];
        sum += cross(domain_->vertices[t[1]] - a, domain_->vertices[t[2]] - a) / 2;
        triangle_sums_.push_back(sum);
    }
    std::size_t count = 0;
    for (const Ring& ring : domain_->rings)
        count += ring.size();
    cells_ = std::clamp(static_cast<int>(count), 8, 512);
    grid_.resize(std::size_t(cells_) * std::size_t(cells_));
    for (const Ring& ring : domain_->rings) {
        for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
            const Edge edge{ring[j], ring[i]};
            const auto [x0, x1] = std::minmax({column(edge.from.x), column(edge.to.x)});
            const auto [y0, y1] = std::minmax({row(edge.from.y), row(edge.to.y)});
            for (int y = y0; y <= y1; ++y)
                for (int x = x0; x <= x1; ++x)
                    grid_[std::size_t(y) * std::size_t(cells_) + std::size_t(x)].push_back(edge);
        }
    }
}

int DomainTest::column(double x) const {
    return std::clamp(static_cast<int>((x - box_.min.x) / box_.size().x * cells_), 0, cells_ - 1);
}

int DomainTest::row(double y) const {
    return std::clamp(static_cast<int>((y - box_.min.y) / box_.size().y * cells_), 0, cells_ - 1);
}

template <class Visit>
void DomainTest::visit_edges_near(const Vec2& point, double distance, const Visit& visit) const {
    const int x1 = column(point.x + distance), y1 = row(point.y + distance);
    for (int y = row(point.y - distance); y <= y1; ++y)
        for (int x = column(point.x - distance); x <= x1; ++x)
            for (const Edge& edge : grid_[std::size_t(y) * std::size_t(cells_) + std::size_t(x)])
                if (segment_distance(point, edge.from, edge.to) <= distance)
                    visit(edge);
}

bool DomainTest::contains_point(const Vec2& point) const { return contains(*domain_, point); }

Vec2 DomainTest::wrapped(const Vec2& point) const {
    if (!is_torus())
        return point;
    const auto wrap = [](double value, double low, double period) {
        const double result = value - std::floor((value - low) / period) * period;
        return result < low + period ? result : low; // rounding may reach the far end
    };
    return {wrap(point.x, box_.min.x, period_.x), wrap(point.y, box_.min.y, period_.y)};
}

Vec2 DomainTest::nearest_image(const Vec2& offset) const {
    if (!is_torus())
        return offset;
    return {offset.x - std::round(offset.x / period_.x) * period_.x,
            offset.y - std::round(offset.y / period_.y) * period_.y};
}

bool DomainTest::accepts(const CollisionShape& shape, const FigurePose& pose,
                         double clearance) const {
    if (is_torus())
        return true;
    if (inside_ == Inside::centre)
        return contains_point(pose.position);
    if (!box_.intersects(pose.position))
        return false;
    const double tolerance = tolerance_ + clearance;
    bool near = false, crossed = false;
    visit_edges_near(pose.position, shape.radius() * pose.scale + tolerance, [&](const Edge& edge) {
        near = true;
        if (crossed)
            return;
        for (const Ring& ring : shape.outline().rings) {
            Vec2 from = pose.apply(ring.back());
            for (const Vec2& v : ring) {
                const Vec2 to = pose.apply(v);
                if (!segments_apart(from, to, edge.from, edge.to, tolerance)) {
                    crossed = true;
                    return;
                }
                from = to;
            }
        }
        crossed = contains(shape.outline(), pose.apply_inverse(edge.from));
    });
    if (crossed)
        return false;
    if (!near)
        return contains_point(pose.position);
    return std::ranges::all_of(shape.outer_vertices(),
                               [&](const Vec2& v) { return contains_point(pose.apply(v)); });
}

Vec2 DomainTest::sample(Random& random) const {
    const double target = random.uniform() * triangle_sums_.back();
    const auto found = std::upper_bound(triangle_sums_.begin(), triangle_sums_.end() - 1, target);
    const auto& t = domain_->triangles[std::size_t(found - triangle_sums_.begin())];
    double u = random.uniform(), v = random.uniform();
    if (u + v > 1) {
        u = 1 - u;
        v = 1 - v;
    }
    const Vec2& a = domain_->vertices[t[0]];
    return a + (domain_->vertices[t[1]] - a) * u + (domain_->vertices[t[2]] - a) * v;
}

} // namespace scree
