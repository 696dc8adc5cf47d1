// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes/field/plain_fields.h"

#include "shapes/field/range_union.h"

#include <array>

namespace scree {

namespace {

std::array<Vec2, 4> corners(const Box2& box) {
    return {box.min, Vec2(box.max.x, box.min.y), box.max, Vec2(box.min.x, box.max.y)};
}

double direction(const Vec2& v) { return degrees(std::atan2(v.y, v.x)); }

} // namespace

double GradientField::value(double share) const {
    return values_.low + (values_.high - values_.low) * std::clamp(share, 0.0, 1.0);
}

double GradientField::at(const Vec2& point) const {
    const Vec2 along = to_ - from_;
    const Vec2 there = point - from_;
    return value(radial_ ? there.length() / along.length() : there.dot(along) / along.length2());
}

Range GradientField::over(const Box2& box) const {
    // The share is monotone along each axis (when radial, on both sides of the centre), so its
    // extremes are at the corners and at the point nearest to the centre.
    RangeUnion all(false);
    for (const Vec2& corner : corners(box)) {
        const double value = at(corner);
        all.add({value, value});
    }
    if (radial_) {
        const double value = at(
            {std::clamp(from_.x, box.min.x, box.max.x), std::clamp(from_.y, box.min.y, box.max.y)});
        all.add({value, value});
    }
    return all.range();
}

double WhirlField::at(const Vec2& point) const {
    return positive_angle(direction(point - centre_) + turn_);
}

Range WhirlField::over(const Box2& box) const {
    if (box.intersects(centre_))
        return {0, 360};
    // Seen from outside, a box spans less than half a turn, between two of its corners.
    const Vec2 to_middle = box.center() - centre_;
    double low = 0;
    double high = 0;
    for (const Vec2& corner : corners(box)) {
        const Vec2 to = corner - centre_;
        const double sine = cross(to_middle, to);
        const double cosine = to_middle.dot(to);
        // For a small angle its tangent is an upper bound, less than 3% too large, and cheaper.
        const double turn =
            degrees(std::abs(sine) < 0.3 * cosine ? sine / cosine : std::atan2(sine, cosine));
        low = std::min(low, turn);
        high = std::max(high, turn);
    }
    const double middle = direction(to_middle);
    const double from = positive_angle(middle + low + turn_);
    return {from, from + (high - low)};
}

} // namespace scree
