// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/warps.h"
#include "render/bsdf/coat.h"
#include "render/bsdf/translucent_lobes.h"

namespace scree {

BsdfValue CoatLobe::evaluate(const Bsdf& at, const Vec3& wo, const Vec3& wi,
                             float /*diffuse_scale*/) const {
    const auto [reflected, pdf] = coat::evaluate(at, wo, wi, at.albedo.at(wo.z));
    return {Color(reflected, reflected, reflected), pdf};
}

BsdfSample CoatLobe::sample(const Bsdf& at, const Vec3& wo, float choice, const Vec2f& u) const {
    if (choice >= at.albedo.at(wo.z)) // even a black medium may let light through
        return {-warp::cosine_hemisphere(u), Color(1.0F, 1.0F, 1.0F), 1, true, true};
    const Vec3 wi = ggx::reflect(wo, ggx::sample_visible_normal(wo, at.alpha, u));
    if (wi.z <= 0)
        return {};
    const BsdfValue value = CoatLobe::evaluate(at, wo, wi, 1);
    if (!(value.pdf > 0))
        return {};
    return {wi, value.value / value.pdf, value.pdf};
}

} // namespace scree
