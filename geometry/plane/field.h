// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"
#include "core/params.h"
#include "core/range.h"

#include <memory>

namespace scree {

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

/// Samples along the longer side of the grid that a script's function is sampled on.
struct FunctionSamples {
    static constexpr int usual = 256, least = 2, most = 1024;
};

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

/// The field that a parameter of type `field` holds: a number is the same value everywhere. Null
/// when it has no value.
inline std::shared_ptr<const Field> field_of(const Params& params, const std::string& name) {
    if (!params.has(name))
        return nullptr;
    if (auto field = params.object<Field>(name))
        return field;
    return std::make_shared<const ConstantField>(params.number(name));
}

} // namespace scree
