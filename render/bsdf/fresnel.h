// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

#include <algorithm>

namespace scree {

/// Share of unpolarised light that a smooth dielectric reflects (Fresnel 1823); `cosine` >= 0 on
/// the side of the ray, `eta` the other side's index of refraction relative to that side's.
inline float fresnel_dielectric(float cosine, float eta) {
    const float sine2 = (1 - cosine * cosine) / (eta * eta);
    if (sine2 >= 1)
        return 1; // total reflection
    const float other = std::sqrt(1 - sine2);
    const float parallel = (eta * cosine - other) / (eta * cosine + other);
    const float perpendicular = (cosine - eta * other) / (cosine + eta * other);
    return 0.5F * (parallel * parallel + perpendicular * perpendicular);
}

/// The same for a conductor of reflectance `f0` at normal incidence (Schlick 1994).
inline Color fresnel_schlick(float cosine, const Color& f0) {
    const float m = std::clamp(1 - cosine, 0.0F, 1.0F);
    const float m5 = m * m * m * m * m;
    return f0 + (Color(1.0F, 1.0F, 1.0F) - f0) * m5;
}

} // namespace scree
