// SPDX-License-Identifier: GPL-3.0-or-later
// The reflection of a rough dielectric coat, for what has something under it.
#pragma once

#include "render/bsdf/bsdf.h"
#include "render/bsdf/fresnel.h"
#include "render/bsdf/ggx.h"

namespace scree::coat {

struct Reflection {
    float value = 0; // BRDF times cos wi
    float pdf = 0;   // of wi, times the probability
};

/// `probability`: with which the coat is chosen and sampled by a visible normal.
inline Reflection evaluate(const Bsdf& at, const Vec3& wo, const Vec3& wi, float probability) {
    const Vec3 m = ggx::half_vector(wo, wi);
    const float normal_density = ggx::density(m, at.alpha) / (4 * wo.z);
    return {fresnel_dielectric(wo.dot(m), at.eta) * normal_density *
                ggx::shadowing(wo, wi, at.alpha),
            probability * normal_density * ggx::masking(wo, at.alpha)};
}

} // namespace scree::coat
