// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/bsdf/fresnel.h"
#include "render/bsdf/ggx.h"
#include "render/bsdf/glass_lobes.h"

#include <algorithm>

namespace scree {

BsdfSample RoughGlassLobe::sample(const Bsdf& at, const Vec3& wo, float choice,
                                  const Vec2f& u) const {
    const Vec3 m = ggx::sample_visible_normal(wo, at.alpha, u);
    const bool reflected = choice < fresnel_dielectric(std::max(0.0F, wo.dot(m)), at.eta);
    Vec3 wi;
    if (reflected) {
        wi = ggx::reflect(wo, m);
        if (wi.z <= 0)
            return {};
    } else if (!glass::refract(wo, m, at.eta, wi) || wi.z >= 0) {
        return {};
    }
    const BsdfValue value = RoughGlassLobe::evaluate(at, wo, wi, 1);
    if (!(value.pdf > 0))
        return {};
    return {wi, value.value / value.pdf, value.pdf, false, !reflected};
}

BsdfValue RoughGlassLobe::evaluate(const Bsdf& at, const Vec3& wo, const Vec3& wi,
                                   float /*diffuse_scale*/) const {
    if (wi.z == 0)
        return {};
    const bool reflected = wi.z > 0;
    Vec3 m = reflected ? wo + wi : wo + wi * at.eta;
    m /= std::sqrt(m.dot(m));
    if (m.z < 0)
        m = -m;
    const float o = wo.dot(m);
    const float i = wi.dot(m);
    if (!(o > 0) || (i > 0) != reflected)
        return {}; // a facet that one of the two sees from behind
    const float reflectance = fresnel_dielectric(o, at.eta);
    const float root = o + at.eta * i;
    // Density of wi per density of m: Walter's eqs. 14 and 17.
    const float jacobian = reflected ? 1 / (4 * o) : at.eta * at.eta * -i / (root * root);
    const float share = reflected ? reflectance : 1 - reflectance;
    const float common = o * ggx::density(m, at.alpha) / wo.z * jacobian * share;
    const Vec3 other = reflected ? wi : -wi;
    return {Color(common * ggx::shadowing(wo, other, at.alpha)),
            common * ggx::masking(wo, at.alpha)};
}

} // namespace scree
