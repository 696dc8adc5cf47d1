// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/bsdf/glass.h"

#include "render/bsdf/fresnel.h"
#include "render/bsdf/ggx.h"

#include <algorithm>

namespace scree::glass {

namespace {

// Refraction of wo at m (wo.m > 0); false on total reflection.
bool refract(const Vec3& wo, const Vec3& m, float eta, Vec3& wi) {
    const float cosine = wo.dot(m);
    const float sine2 = (1 - cosine * cosine) / (eta * eta);
    if (sine2 >= 1)
        return false;
    wi = m * (cosine / eta - std::sqrt(1 - sine2)) - wo / eta;
    return true;
}

Color grey(float v) { return {v, v, v}; }

} // namespace

BsdfSample sample_smooth(const Vec3& wo, float choice, float eta) {
    BsdfSample sample;
    sample.delta = true;
    sample.pdf = 1;
    sample.weight = grey(1); // both lobes are chosen by their share
    Vec3 refracted;
    if (choice >= fresnel_dielectric(wo.z, eta) &&
        refract(wo, Vec3(0.0F, 0.0F, 1.0F), eta, refracted)) {
        sample.direction = refracted;
        sample.transmitted = true;
    } else {
        sample.direction = {-wo.x, -wo.y, wo.z};
    }
    return sample;
}

BsdfSample sample_rough(const Vec3& wo, float choice, const Vec2f& u, float alpha, float eta) {
    const Vec3 m = ggx::sample_visible_normal(wo, alpha, u);
    const bool reflected = choice < fresnel_dielectric(std::max(0.0F, wo.dot(m)), eta);
    Vec3 wi;
    if (reflected) {
        wi = ggx::reflect(wo, m);
        if (wi.z <= 0)
            return {};
    } else if (!refract(wo, m, eta, wi) || wi.z >= 0) {
        return {};
    }
    const BsdfValue value = evaluate(wo, wi, alpha, eta);
    if (!(value.pdf > 0))
        return {};
    return {wi, value.value / value.pdf, value.pdf, false, !reflected};
}

BsdfValue evaluate(const Vec3& wo, const Vec3& wi, float alpha, float eta) {
    if (!(wo.z > 0) || wi.z == 0)
        return {};
    const bool reflected = wi.z > 0;
    Vec3 m = reflected ? wo + wi : wo + wi * eta;
    m /= std::sqrt(m.dot(m));
    if (m.z < 0)
        m = -m;
    const float o = wo.dot(m);
    const float i = wi.dot(m);
    if (!(o > 0) || (i > 0) != reflected)
        return {}; // a facet that one of the two sees from behind
    const float share = fresnel_dielectric(o, eta);
    const float root = o + eta * i;
    // Density of wi per density of m: Walter's eqs. 14 and 17.
    const float jacobian = reflected ? 1 / (4 * o) : eta * eta * -i / (root * root);
    const float lobe = reflected ? share : 1 - share;
    const float common = o * ggx::density(m, alpha) / wo.z * jacobian * lobe;
    const Vec3 other = reflected ? wi : -wi;
    return {grey(common * ggx::shadowing(wo, other, alpha)), common * ggx::masking(wo, alpha)};
}

} // namespace scree::glass
