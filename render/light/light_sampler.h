// SPDX-License-Identifier: GPL-3.0-or-later
// Sampling of a scene's lights: which light, which direction, with what density.
#pragma once

#include "core/frame.h"
#include "render/light/light_tree.h"
#include "render/light/sky_sampler.h"

#include <span>
#include <vector>

namespace scree {

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

/// All lights of a scene. One light is chosen with probability in proportion to the irradiance it
/// would give, unoccluded, to a surface that faces it; of many area lights, roughly so.
class LightSampler {
  public:
    /// `compensate`: leave the uniform part of the sky to BSDF sampling, which is good at it
    /// (Karlík et al. 2019, "MIS compensation"); for use with MIS only.
    LightSampler(std::span<const Light> lights, bool compensate);

    /// pdf 0 when no light can be sampled from this point.
    LightSample sample(const Vec3& point, float choice, const Vec2f& u) const;

    /// Calls visit(radiance, pdf, light) for every light at infinity that shines along
    /// `direction`; the density is that of `sample` at `point`, `light` counts in the scene's list.
    template <class Visit>
    void at_infinity(const Vec3& point, const Vec3& direction, const Visit& visit) const;

    /// Radiance that leaves area light number `light` (of the scene's list) against `direction`,
    /// and the density with which `sample` would have found it from `point`.
    Color area(std::uint32_t light, const Vec3& point, const Vec3& direction, float distance,
               float& pdf) const;

    bool empty() const { return empty_; }

  private:
    float infinite_weight(std::size_t light) const;
    float total_weight(const Vec3& point) const {
        return infinite_weight_ + areas_.irradiance(point);
    }
    LightSample sample_infinite(float left, const Vec2f& u, float total) const;

    std::vector<std::variant<SkySampler, SunSampler>> infinite_;
    std::vector<std::uint32_t> infinite_number_; // in the scene's list
    float infinite_weight_ = 0;
    LightTree areas_;
    std::vector<std::uint32_t> area_number_; // in the scene's list
    std::vector<std::uint32_t> area_of_;     // the inverse
    bool empty_ = true;
};

template <class Visit>
void LightSampler::at_infinity(const Vec3& point, const Vec3& direction, const Visit& visit) const {
    float total = -1;
    for (std::size_t i = 0; i < infinite_.size(); ++i) {
        Color radiance;
        float pdf = 0;
        if (const auto* sky = std::get_if<SkySampler>(&infinite_[i])) {
            radiance = sky->radiance(direction);
            pdf = sky->pdf(direction);
        } else {
            const auto& sun = std::get<SunSampler>(infinite_[i]);
            radiance = sun.radiance(direction);
            pdf = sun.pdf(direction);
        }
        if (pdf > 0) {
            if (total < 0)
                total = total_weight(point);
            pdf *= infinite_weight(i) / total;
        }
        visit(radiance, pdf, infinite_number_[i]);
    }
}

} // namespace scree
