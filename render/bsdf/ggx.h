// SPDX-License-Identifier: GPL-3.0-or-later
// The isotropic GGX microfacet distribution (Walter et al. 2007) in the frame of the normal (z).
#pragma once

#include "core/math.h"

#include <algorithm>

namespace scree::ggx {

/// Below this the lobe is narrower than 0.1 degrees and single precision runs out.
constexpr float min_alpha = 1e-3F;

/// By the perceptual roughness (Burley 2012).
inline float alpha(float roughness) { return std::max(min_alpha, roughness * roughness); }

/// Density of microfacet normals per solid angle and projected area. By the tangent, not by the
/// cosine, whose difference from 1 has no digits left for small alpha.
inline float density(const Vec3& m, float alpha) {
    const float inverse = 1 / (alpha * alpha);
    const float root = (m.x * m.x + m.y * m.y) * inverse + m.z * m.z;
    return inverse / (pi_f * root * root);
}

/// Smith's Lambda for a direction above the surface (Heitz 2014, eq. 72).
inline float lambda(const Vec3& w, float alpha) {
    const float tangent2 = (w.x * w.x + w.y * w.y) / (w.z * w.z);
    return 0.5F * (std::sqrt(1 + alpha * alpha * tangent2) - 1);
}

inline float masking(const Vec3& w, float alpha) { return 1 / (1 + lambda(w, alpha)); }

/// Height-correlated masking and shadowing of two directions on one side (Heitz 2014, eq. 99).
inline float shadowing(const Vec3& wo, const Vec3& wi, float alpha) {
    return 1 / (1 + lambda(wo, alpha) + lambda(wi, alpha));
}

/// Density of `sample_visible_normal` per solid angle (Heitz 2018, eq. 3).
inline float visible_density(const Vec3& wo, const Vec3& m, float alpha) {
    return masking(wo, alpha) * std::max(0.0F, wo.dot(m)) * density(m, alpha) / wo.z;
}

/// A microfacet normal that `wo` (wo.z > 0) sees (Dupuy & Benyoub 2023, listing 3).
inline Vec3 sample_visible_normal(const Vec3& wo, float alpha, const Vec2f& u) {
    const Vec3 stretched = Vec3(wo.x * alpha, wo.y * alpha, wo.z);
    const Vec3 standard = stretched / std::sqrt(stretched.dot(stretched));
    const float z = (1 - u.y) * (1 + standard.z) - standard.z;
    const float sine = std::sqrt(std::clamp(1 - z * z, 0.0F, 1.0F));
    const float angle = 2 * pi_f * u.x;
    const Vec3 half(sine * std::cos(angle) + standard.x, sine * std::sin(angle) + standard.y,
                    z + standard.z);
    const Vec3 m(half.x * alpha, half.y * alpha, half.z);
    return m / std::sqrt(m.dot(m));
}

/// Of two directions whose sum is not 0.
inline Vec3 half_vector(const Vec3& wo, const Vec3& wi) {
    const Vec3 sum = wo + wi;
    return sum / std::sqrt(sum.dot(sum));
}

inline Vec3 reflect(const Vec3& w, const Vec3& m) { return m * (2 * w.dot(m)) - w; }

} // namespace scree::ggx
