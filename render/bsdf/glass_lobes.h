// SPDX-License-Identifier: GPL-3.0-or-later
// A dielectric interface. It carries radiance over the square of the index of refraction, which
// refraction keeps: with eye and lights in air the factors of Walter et al. 2007, eq. 21, cancel
// along every path.
#pragma once

#include "render/bsdf/bsdf.h"

namespace scree {

namespace glass {

/// Refraction of `wo` at the normal `m` (wo.m > 0) into `wi`; false on total reflection. `eta` as
/// in Bsdf.
inline bool refract(const Vec3& wo, const Vec3& m, float eta, Vec3& wi) {
    const float cosine = wo.dot(m);
    const float sine2 = (1 - cosine * cosine) / (eta * eta);
    if (sine2 >= 1)
        return false;
    wi = m * (cosine / eta - std::sqrt(1 - sine2)) - wo / eta;
    return true;
}

} // namespace glass

/// Smooth (Fresnel 1823).
class SmoothGlassLobe final : public Lobe {
  public:
    SmoothGlassLobe() : Lobe({.delta = true, .mirrors = true}) {}
    BsdfValue evaluate(const Bsdf& at, const Vec3& wo, const Vec3& wi,
                       float diffuse_scale) const override;
    BsdfSample sample(const Bsdf& at, const Vec3& wo, float choice, const Vec2f& u) const override;
};

/// Rough (Walter et al. 2007).
class RoughGlassLobe final : public Lobe {
  public:
    RoughGlassLobe() : Lobe({.two_sided = true, .mirrors = true}) {}
    BsdfValue evaluate(const Bsdf& at, const Vec3& wo, const Vec3& wi,
                       float diffuse_scale) const override;
    BsdfSample sample(const Bsdf& at, const Vec3& wo, float choice, const Vec2f& u) const override;
};

} // namespace scree
