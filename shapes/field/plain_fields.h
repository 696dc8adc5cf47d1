// SPDX-License-Identifier: GPL-3.0-or-later
// Fields defined by a formula.
#pragma once

#include "geometry/plane/field.h"

namespace scree {

/// A linear ramp from `values.low` at `from` to `values.high` at `to`, constant beyond both. Its
/// level lines are perpendicular to the line between the points, or circles about `from` when
/// `radial`. The two points must differ.
class GradientField final : public Field {
  public:
    GradientField(const Vec2& from, const Vec2& to, const Range& values, bool radial)
        : from_(from), to_(to), values_(values), radial_(radial) {}
    double at(const Vec2& point) const override;
    Range over(const Box2& box) const override;

  private:
    double value(double share) const;

    Vec2 from_;
    Vec2 to_;
    Range values_; // at both ends; `low` may be the larger one
    bool radial_;
};

/// The direction away from `centre`, rotated by `turn` [deg] from +x towards +z; an angle in
/// [0, 360). It is discontinuous only at the centre, where it is `turn`.
class WhirlField final : public Field {
  public:
    WhirlField(const Vec2& centre, double turn) : centre_(centre), turn_(turn) {}
    double at(const Vec2& point) const override;
    Range over(const Box2& box) const override;
    double period() const override { return 360; }

  private:
    Vec2 centre_;
    double turn_;
};

} // namespace scree
