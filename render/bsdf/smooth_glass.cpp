// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/bsdf/fresnel.h"
#include "render/bsdf/glass_lobes.h"

namespace scree {

BsdfValue SmoothGlassLobe::evaluate(const Bsdf& /*at*/, const Vec3& /*wo*/, const Vec3& /*wi*/,
                                    float /*diffuse_scale*/) const {
    return {};
}

BsdfSample SmoothGlassLobe::sample(const Bsdf& at, const Vec3& wo, float choice,
                                   const Vec2f& /*u*/) const {
    // Reflection and refraction are chosen by their shares, so that both weigh 1.
    BsdfSample sample{
        .direction = {-wo.x, -wo.y, wo.z}, .weight = {1.0F, 1.0F, 1.0F}, .pdf = 1, .delta = true};
    if (choice >= fresnel_dielectric(wo.z, at.eta))
        sample.transmitted = glass::refract(wo, Vec3(0.0F, 0.0F, 1.0F), at.eta, sample.direction);
    return sample;
}

} // namespace scree
