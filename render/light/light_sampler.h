// SPDX-License-Identifier: GPL-3.0-or-later
// Sampling of a scene's lights: which light, which direction, with what density.
#pragma once

#include "core/frame.h"
#include "render/light/sky_sampler.h"

#include <span>
#include <vector>

namespace scree {

/// A direction in which light may arrive.
struct LightSample {
    Vec3 direction;     // unit, towards the light
    float distance = 0; // [m]; infinite for sky and sun
    Color radiance{0.0F, 0.0F, 0.0F};
    float pdf = 0; // per solid angle, with the choice of the light; 0: no light
};

/// A uniform cone of directions: the sun.
class SunSampler {
  public:
    explicit SunSampler(const Sun& sun);

    Color radiance(const Vec3& direction) const;
    float pdf(const Vec3& direction) const;
    Vec3 sample(const Vec2f& u) const;
    float irradiance() const { return irradiance_; }

  private:
    bool inside(const Vec3& direction) const;

    Vec3 direction_;
    Frame frame_; // about it
    Color radiance_;
    float cap_;    // 1 - cos of the angular radius
    float chord2_; // squared distance from the axis to the rim on the unit sphere
    float pdf_;
    float irradiance_;
};

/// A rectangle, sampled uniformly by area.
class AreaSampler {
  public:
    explicit AreaSampler(const AreaLight& light);

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

/// All lights of a scene. One light is chosen with probability in proportion to the irradiance it
/// would give, unoccluded, to a surface that faces it.
class LightSampler {
  public:
    /// `compensate`: leave the uniform part of the sky to BSDF sampling, which is good at it
    /// (Karlík et al. 2019, "MIS compensation"); for use with MIS only.
    LightSampler(std::span<const Light> lights, bool compensate);

    /// pdf 0 when no light can be sampled from this point.
    LightSample sample(const Vec3& point, float choice, const Vec2f& u) const;

    /// Calls visit(radiance, pdf) for every light at infinity that shines along `direction`; the
    /// density is that of `sample` at `point`.
    template <class Visit>
    void at_infinity(const Vec3& point, const Vec3& direction, const Visit& visit) const;

    /// Radiance that leaves area light number `light` (of the scene's list) against `direction`,
    /// and the density with which `sample` would have found it from `point`.
    Color area(std::uint32_t light, const Vec3& point, const Vec3& direction, float distance,
               float& pdf) const;

    bool empty() const { return sampled_count_ == 0; }

  private:
    float weight(std::size_t light, const Vec3& point) const;
    float total_weight(const Vec3& point) const;

    std::vector<std::variant<SkySampler, SunSampler, AreaSampler>> lights_;
    std::vector<std::uint32_t> infinite_; // indices of skies and suns
    float infinite_weight_ = 0;
    std::vector<std::uint32_t> areas_;
    std::size_t sampled_count_ = 0;
};

template <class Visit>
void LightSampler::at_infinity(const Vec3& point, const Vec3& direction, const Visit& visit) const {
    float total = -1;
    for (const std::uint32_t i : infinite_) {
        Color radiance;
        float pdf = 0;
        if (const auto* sky = std::get_if<SkySampler>(&lights_[i])) {
            radiance = sky->radiance(direction);
            pdf = sky->pdf(direction);
        } else {
            const auto& sun = std::get<SunSampler>(lights_[i]);
            radiance = sun.radiance(direction);
            pdf = sun.pdf(direction);
        }
        if (pdf > 0) {
            if (total < 0)
                total = total_weight(point);
            pdf *= weight(i, point) / total;
        }
        visit(radiance, pdf);
    }
}

} // namespace scree
