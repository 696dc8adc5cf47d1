// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

namespace scree {

/// Lowest and highest of a set of numbers.
struct Range {
    double low = 0;
    double high = 0;
};

/// A number at every point of the ground plane (x, z): a direction, a scale, a density, a class.
class Field {
  public:
    Field() = default;
    Field(const Field&) = delete;
    Field& operator=(const Field&) = delete;
    virtual ~Field() = default;

    virtual double at(const Vec2& point) const = 0;

    /// Bounds of `at` over a box: no value in it lies outside, up to rounding. They approach the
    /// value as the box shrinks, except where the field jumps. Where the field is periodic, a range
    /// as long as its period means every value.
    virtual Range over(const Box2& box) const = 0;

    /// Values that differ by this mean the same (360 for an angle in degrees); 0: none do.
    virtual double period() const { return 0; }
};

} // namespace scree
