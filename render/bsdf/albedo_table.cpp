// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/bsdf/albedo_table.h"

#include "render/bsdf/fresnel.h"
#include "render/bsdf/ggx.h"

#include <algorithm>

namespace scree {

namespace {

constexpr int samples_per_side = 32; // of the unit square

float single_bounce(float cosine, float alpha, float ior) {
    const Vec3 wo(std::sqrt(std::max(0.0F, 1 - cosine * cosine)), 0.0F, cosine);
    double sum = 0;
    double weights = 0;
    for (int j = 0; j < samples_per_side; ++j) {
        // Facets are flattest at u.y = 1, where the integrand falls steeply to 0: with steps that
        // shrink by the cube towards it the sum is within 0.1% of the integral.
        const float left = (static_cast<float>(j) + 0.5F) / samples_per_side;
        const float weight = left * left;
        weights += double(weight);
        for (int i = 0; i < samples_per_side; ++i) {
            const Vec2f u((static_cast<float>(i) + 0.5F) / samples_per_side,
                          1 - left * left * left);
            const Vec3 m = ggx::sample_visible_normal(wo, alpha, u);
            const Vec3 wi = ggx::reflect(wo, m);
            if (wi.z <= 0)
                continue;
            const float facet = ior == AlbedoTable::mirror ? 1 : fresnel_dielectric(wo.dot(m), ior);
            sum += double(weight * facet * ggx::shadowing(wo, wi, alpha) / ggx::masking(wo, alpha));
        }
    }
    return static_cast<float>(sum / (weights * samples_per_side));
}

} // namespace

AlbedoTable::AlbedoTable(float alpha, float ior) {
    for (int i = 0; i < size; ++i) {
        // At grazing incidence the formulas divide by zero; a cosine of a thousandth is near
        // enough.
        const float cosine = std::max(1e-3F, static_cast<float>(i) / (size - 1));
        values_[static_cast<unsigned>(i)] = single_bounce(cosine, alpha, ior);
    }
    // 2 * integral of E(x) x dx over the linear pieces.
    double sum = 0;
    for (int i = 0; i + 1 < size; ++i) {
        const double a = static_cast<double>(i) / (size - 1);
        const double b = static_cast<double>(i + 1) / (size - 1);
        const double fa = double(values_[static_cast<unsigned>(i)]);
        const double fb = double(values_[static_cast<unsigned>(i + 1)]);
        sum += (b - a) / 6 * (fa * a + (fa + fb) * (a + b) + fb * b);
    }
    average_ = static_cast<float>(2 * sum);
}

const AlbedoTable* RoughnessTables::table(int step) const {
    LazyTable& lazy = tables_[static_cast<std::size_t>(step)];
    std::call_once(lazy.made, [&] {
        lazy.table = AlbedoTable(ggx::alpha(static_cast<float>(step) / steps), ior_);
    });
    return &lazy.table;
}

Albedo RoughnessTables::at(float roughness) const {
    const float position = std::clamp(roughness, 0.0F, 1.0F) * steps;
    const int step = std::min(static_cast<int>(position), steps - 1);
    return {table(step), table(step + 1), position - static_cast<float>(step)};
}

} // namespace scree
