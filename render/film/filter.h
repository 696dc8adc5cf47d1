// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/distribution.h"
#include "core/math.h"
#include "model/film_settings.h"

namespace scree {

/// Value of a reconstruction filter at distance `x` from its centre along one axis, not
/// normalised; 0 outside the radius. The Gaussian has a deviation of a third of the radius.
float filter_value(Filter filter, float radius, float x);

/// Draws offsets from a pixel's centre with the density of the separable filter, which must not be
/// negative anywhere (Ernst, Stamminger & Greiner 2006).
class FilterSampler {
  public:
    FilterSampler(Filter filter, float radius);

    Vec2f offset(const Vec2f& u) const { return {inverse(u.x), inverse(u.y)}; } // [pixels]

  private:
    float inverse(float u) const;

    float radius_;
    Distribution1D distribution_; // over [-radius, radius]
};

} // namespace scree
