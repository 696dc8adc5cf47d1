// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/distribution.h"
#include "model/light.h"

namespace scree {

/// The radiance of a sky, and directions sampled in proportion to it.
class SkySampler {
  public:
    SkySampler(const Sky& sky, bool compensate);

    Color radiance(const Vec3& direction) const;
    float pdf(const Vec3& direction) const; // per solid angle
    Vec3 sample(const Vec2f& u, float& pdf) const;

    /// Irradiance of what `sample` covers, on a surface that faces all of it [W/m^2].
    float irradiance() const { return irradiance_; }

  private:
    Vec2f image_from_direction(const Vec3& direction) const;
    Vec3 direction_from_image(const Vec2f& p, std::size_t& row) const;
    Color texel(int x, int y) const;

    Sky sky_;
    bool constant_ = false;
    float cos_rotation_ = 1;
    float sin_rotation_ = 0;
    Distribution2D distribution_; // over the latitude-longitude image
    std::vector<float> cosines_;  // of the rows' edges, from the top; one more than rows
    std::vector<float> scale_;    // density per solid angle over that per image, by rows
    float irradiance_ = 0;
};

} // namespace scree
