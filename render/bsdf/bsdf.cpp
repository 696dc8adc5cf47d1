// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/bsdf/bsdf.h"

#include "core/warps.h"
#include "render/bsdf/fresnel.h"
#include "render/bsdf/ggx.h"
#include "render/bsdf/glass.h"

#include <algorithm>

namespace scree {

namespace {

Vec3 half_vector(const Vec3& wo, const Vec3& wi) {
    const Vec3 sum = wo + wi;
    return sum / std::sqrt(sum.dot(sum));
}

BsdfValue matte(const Bsdf& bsdf, const Vec3& wi, float scale) {
    const float pdf = wi.z / pi_f;
    return {bsdf.color * (scale * pdf), pdf};
}

// A GGX coat over a diffuse base that gets what the coat lets in and gives back what it lets out
// (Kelemen & Szirmay-Kalos 2001, eq. 14): reciprocal, and a white base loses nothing.
float coat_probability(const Bsdf& bsdf, float cosine) {
    const float coat = bsdf.albedo.at(cosine);
    const float base = (1 - coat) * std::max({bsdf.color.x, bsdf.color.y, bsdf.color.z});
    return coat / (coat + base);
}

BsdfValue plastic(const Bsdf& bsdf, const Vec3& wo, const Vec3& wi, float scale) {
    const Albedo& albedo = bsdf.albedo;
    const float base =
        scale * (1 - albedo.at(wo.z)) * (1 - albedo.at(wi.z)) / (1 - albedo.average());
    const Vec3 m = half_vector(wo, wi);
    const float normal_density = ggx::density(m, bsdf.alpha) / (4 * wo.z);
    const float coat = fresnel_dielectric(wo.dot(m), bsdf.eta) * normal_density *
                       ggx::shadowing(wo, wi, bsdf.alpha);
    const float p = coat_probability(bsdf, wo.z);
    return {bsdf.color * (base * wi.z / pi_f) + Color(coat, coat, coat),
            p * normal_density * ggx::masking(wo, bsdf.alpha) + (1 - p) * wi.z / pi_f};
}

// The coat alone. What it lets in is seen again at `emerging` surfaces, which let as much out as
// the base of a plastic does.
BsdfValue translucent(const Bsdf& bsdf, const Vec3& wo, const Vec3& wi) {
    const Vec3 m = half_vector(wo, wi);
    const float normal_density = ggx::density(m, bsdf.alpha) / (4 * wo.z);
    const float coat = fresnel_dielectric(wo.dot(m), bsdf.eta) * normal_density *
                       ggx::shadowing(wo, wi, bsdf.alpha);
    return {Color(coat, coat, coat),
            bsdf.albedo.at(wo.z) * normal_density * ggx::masking(wo, bsdf.alpha)};
}

BsdfSample sample_translucent(const Bsdf& bsdf, const Vec3& wo, float choice, const Vec2f& u) {
    if (choice >= bsdf.albedo.at(wo.z)) // even a black medium may let light through
        return {-warp::cosine_hemisphere(u), Color(1.0F, 1.0F, 1.0F), 1, true, true};
    const Vec3 wi = ggx::reflect(wo, ggx::sample_visible_normal(wo, bsdf.alpha, u));
    if (wi.z <= 0)
        return {};
    const BsdfValue value = translucent(bsdf, wo, wi);
    if (!(value.pdf > 0))
        return {};
    return {wi, value.value / value.pdf, value.pdf, false, false};
}

BsdfValue emerging(const Bsdf& bsdf, const Vec3& wi, float scale) {
    const float pdf = wi.z / pi_f;
    const float value = scale * (1 - bsdf.albedo.at(wi.z)) / (1 - bsdf.albedo.average()) * pdf;
    return {Color(value, value, value), pdf};
}

// Energy of the further bounces between facets, in proportion to the first (Turquin 2019, eq. 16).
Color metal_gain(const Bsdf& bsdf, float cosine) {
    const float single = bsdf.albedo.at(cosine);
    return Color(1.0F, 1.0F, 1.0F) + bsdf.color * ((1 - single) / single);
}

BsdfValue metal(const Bsdf& bsdf, const Vec3& wo, const Vec3& wi) {
    const Vec3 m = half_vector(wo, wi);
    const float normal_density = ggx::density(m, bsdf.alpha) / (4 * wo.z);
    return {fresnel_schlick(wo.dot(m), bsdf.color) * metal_gain(bsdf, wo.z) *
                (normal_density * ggx::shadowing(wo, wi, bsdf.alpha)),
            normal_density * ggx::masking(wo, bsdf.alpha)};
}

BsdfSample sample_metal(const Bsdf& bsdf, const Vec3& wo, const Vec2f& u) {
    const Vec3 m = ggx::sample_visible_normal(wo, bsdf.alpha, u);
    const Vec3 wi = ggx::reflect(wo, m);
    if (wi.z <= 0)
        return {};
    const float masking = ggx::masking(wo, bsdf.alpha);
    BsdfSample sample;
    sample.direction = wi;
    sample.weight = fresnel_schlick(wo.dot(m), bsdf.color) * metal_gain(bsdf, wo.z) *
                    (ggx::shadowing(wo, wi, bsdf.alpha) / masking);
    sample.pdf = masking * ggx::density(m, bsdf.alpha) / (4 * wo.z);
    return sample;
}

BsdfSample sample_plastic(const Bsdf& bsdf, const Vec3& wo, float choice, const Vec2f& u) {
    const bool coat = choice < coat_probability(bsdf, wo.z);
    const Vec3 wi = coat ? ggx::reflect(wo, ggx::sample_visible_normal(wo, bsdf.alpha, u))
                         : warp::cosine_hemisphere(u);
    if (wi.z <= 0)
        return {};
    const BsdfValue value = plastic(bsdf, wo, wi, 1);
    if (!(value.pdf > 0))
        return {};
    return {wi, value.value / value.pdf, value.pdf, false, false};
}

} // namespace

BsdfValue Bsdf::evaluate(const Vec3& wo, const Vec3& wi, float diffuse_scale) const {
    if (kind == BsdfKind::rough_glass)
        return glass::evaluate(wo, wi, alpha, eta);
    if (!(wi.z > 0) || !(wo.z > 0))
        return {};
    switch (kind) {
    case BsdfKind::matte:
        return matte(*this, wi, diffuse_scale);
    case BsdfKind::plastic:
        return plastic(*this, wo, wi, diffuse_scale);
    case BsdfKind::metal:
        return metal(*this, wo, wi);
    case BsdfKind::translucent:
        return translucent(*this, wo, wi);
    case BsdfKind::emerging:
        return emerging(*this, wi, diffuse_scale);
    case BsdfKind::smooth_glass:
    case BsdfKind::rough_glass:
        break;
    }
    return {};
}

BsdfSample Bsdf::sample(const Vec3& wo, float choice, const Vec2f& u) const {
    if (!(wo.z > 0))
        return {};
    switch (kind) {
    case BsdfKind::matte: {
        const Vec3 wi = warp::cosine_hemisphere(u);
        return {wi, color, wi.z / pi_f, false, false};
    }
    case BsdfKind::plastic:
        return sample_plastic(*this, wo, choice, u);
    case BsdfKind::metal:
        return sample_metal(*this, wo, u);
    case BsdfKind::smooth_glass:
        return glass::sample_smooth(wo, choice, eta);
    case BsdfKind::rough_glass:
        return glass::sample_rough(wo, choice, u, alpha, eta);
    case BsdfKind::translucent:
        return sample_translucent(*this, wo, choice, u);
    case BsdfKind::emerging: {
        const Vec3 wi = warp::cosine_hemisphere(u);
        const BsdfValue value = emerging(*this, wi, 1);
        return {wi, value.value / value.pdf, value.pdf, false, false};
    }
    }
    return {};
}

} // namespace scree
