// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

#include <span>
#include <vector>

namespace scree {

/// How far a set of points reaches in any direction, in constant time: never less than it does, and
/// little more. The reach is known exactly along a grid of directions; it is a convex function of
/// the direction (Rockafellar 1970, section 13), so that between them the weighted mean of the
/// three around is a bound.
class SupportFunction {
  public:
    SupportFunction() = default; // of no points: known for no direction
    explicit SupportFunction(std::span<const Vec3> points);

    bool known() const { return !reach_.empty(); }

    /// At least the largest dot product of `direction`, of any length, with one of the points, but
    /// for rounding.
    float operator()(const Vec3& direction) const;

  private:
    std::vector<float> reach_; // by octant and place on it
};

} // namespace scree
