// SPDX-License-Identifier: GPL-3.0-or-later
// Fields given by a formula.
#pragma once

#include "core/field.h"

#include <memory>
#include <utility>

namespace scree {

/// The same value everywhere: what a plain number means where a field is asked for.
class ConstantField final : public Field {
  public:
    explicit ConstantField(double value) : value_(value) {}
    double at(const Vec2& /*point*/) const override { return value_; }
    Range over(const Box2& /*box*/) const override { return {value_, value_}; }

  private:
    double value_;
};

/// The product of two fields of which neither is below 0.
class ProductField final : public Field {
  public:
    ProductField(std::shared_ptr<const Field> a, std::shared_ptr<const Field> b)
        : a_(std::move(a)), b_(std::move(b)) {}
    double at(const Vec2& point) const override { return a_->at(point) * b_->at(point); }
    Range over(const Box2& box) const override {
        const Range a = a_->over(box);
        const Range b = b_->over(box);
        return {a.low * b.low, a.high * b.high};
    }

  private:
    std::shared_ptr<const Field> a_;
    std::shared_ptr<const Field> b_;
};

/// A ramp from `values.low` at `from` to `values.high` at `to`, constant beyond both; across the
/// line between them, or when radial in circles about `from`. The two points differ.
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

/// The direction away from `centre`, turned from +x towards +z by `turn` [deg]; an angle in
/// [0, 360). It jumps at the centre alone, where it is `turn`.
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
