// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"
#include "model/light.h"

namespace scree {

/// A direction in which light may arrive.
struct LightSample {
    Vec3 direction{0.0F, 0.0F, 0.0F}; // unit, towards the light
    float distance = 0;               // [m]; infinite for sky and sun
    Color radiance{0.0F, 0.0F, 0.0F};
    float pdf = 0;           // per solid angle, with the choice of the light; 0: no light
    std::uint32_t light = 0; // its number in the scene's list
};

/// A rectangle, sampled uniformly by area.
class AreaSampler {
  public:
    explicit AreaSampler(const AreaLight& light);

    const Vec3& normal() const { return normal_; }
    std::array<Vec3, 4> corners() const { return light_.corners(); }
    /// Luminance times area.
    float power() const { return luminance(radiance_) * area_; }

    /// Light from the front only.
    Color radiance(const Vec3& direction) const {
        return direction.dot(normal_) < 0 ? radiance_ : Color(0.0F, 0.0F, 0.0F);
    }
    /// Density of arriving at distance `distance` along `direction` from some point.
    float pdf(const Vec3& direction, float distance) const;
    LightSample sample(const Vec3& point, const Vec2f& u) const;
    /// An estimate of the irradiance at `point` on a surface that faces the light; 0 only where the
    /// irradiance is 0.
    float irradiance(const Vec3& point) const;

  private:
    AreaLight light_;
    Color radiance_;
    Vec3 normal_;
    float area_;
};

} // namespace scree
