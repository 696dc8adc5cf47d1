// SPDX-License-Identifier: GPL-3.0-or-later
// Maps from the unit square to other sampling domains, each with its density and its inverse. They
// preserve area unless they say otherwise. T is float or double.
#pragma once

#include "core/math.h"

#include <algorithm>

namespace scree::warp {

/// Sine and cosine for |x| <= pi / 4 by Taylor series with truncation errors below 2^-24: inlined,
/// and the same bits with every C library.
inline void short_sine_cosine(float x, float& sine, float& cosine) {
    const float x2 = x * x;
    sine = x * (1 + x2 * (-1.0F / 6 + x2 * (1.0F / 120 + x2 * (-1.0F / 5040 + x2 / 362880))));
    cosine = 1 + x2 * (-0.5F + x2 * (1.0F / 24 + x2 * (-1.0F / 720 + x2 / 40320)));
}

/// The unit disk, concentrically (Shirley & Chiu 1997).
inline Vec2f disk(const Vec2f& u) {
    const float a = 2 * u.x - 1;
    const float b = 2 * u.y - 1;
    if (a == 0 && b == 0)
        return {0.0F, 0.0F};
    // Branch-free, since the condition is random and would be mispredicted.
    const bool steep = std::abs(b) >= std::abs(a);
    const float radius = steep ? b : a;
    constexpr auto quarter = static_cast<float>(pi / 4);
    float sine = 0;
    float cosine = 0;
    short_sine_cosine(quarter * ((steep ? a : b) / radius), sine, cosine);
    return {radius * (steep ? sine : cosine), radius * (steep ? cosine : sine)};
}
inline constexpr float disk_density = 1 / pi_f;
inline Vec2f disk_inverse(const Vec2f& p) {
    const bool steep = std::abs(p.y) >= std::abs(p.x);
    const float longer = steep ? p.y : p.x;
    if (longer == 0)
        return {0.5F, 0.5F};
    const float radius = std::copysign(std::sqrt(p.x * p.x + p.y * p.y), longer);
    const float other = radius * std::atan((steep ? p.x : p.y) / longer) * (4 / pi_f);
    return Vec2f(steep ? other : radius, steep ? radius : other) * 0.5F + Vec2f(0.5F);
}

/// Directions about +z with a density proportional to their cosine (Malley's method).
inline Vec3 cosine_hemisphere(const Vec2f& u) {
    const Vec2f d = disk(u);
    return {d.x, d.y, std::sqrt(std::max(0.0F, 1 - d.x * d.x - d.y * d.y))};
}
inline float cosine_hemisphere_density(const Vec3& w) { return std::max(0.0F, w.z) / pi_f; }
inline Vec2f cosine_hemisphere_inverse(const Vec3& w) { return disk_inverse({w.x, w.y}); }

/// Uniform directions with z >= 1 - `height`, a spherical cap; `height` in (0, 2]. Accurate for
/// small heights too.
inline Vec3 cap(const Vec2f& u, float height) {
    const Vec2f d = disk(u);
    const float below = height * (d.x * d.x + d.y * d.y); // 1 - z
    const float stretch = std::sqrt(height * (2 - below));
    return {stretch * d.x, stretch * d.y, 1 - below};
}
inline float cap_density(float height) { return 1 / (2 * pi_f * height); }
inline Vec2f cap_inverse(const Vec3& w, float height) {
    // 1 - z, computed from the sine for small angles, where 1 - w.z would cancel.
    const float sine2 = w.x * w.x + w.y * w.y;
    const float below = w.z > 0 ? sine2 / (1 + w.z) : 1 - w.z;
    return disk_inverse(Vec2f(w.x, w.y) / std::sqrt(height * (2 - below)));
}

/// Uniform directions (Archimedes' cylinder): u.x gives z, u.y the azimuth.
template <class T>
Imath::Vec3<T> sphere(const Imath::Vec2<T>& u) {
    const T z = 2 * u.x - 1;
    const T angle = 2 * std::numbers::pi_v<T> * u.y;
    const T r = std::sqrt(std::max(T(0), 1 - z * z));
    return {r * std::cos(angle), r * std::sin(angle), z};
}
inline constexpr float sphere_density = 1 / (4 * pi_f);
template <class T>
Imath::Vec2<T> sphere_inverse(const Imath::Vec3<T>& w) {
    const T turn = std::atan2(w.y, w.x) / (2 * std::numbers::pi_v<T>);
    return {(w.z + 1) / 2, turn < 0 ? turn + 1 : turn};
}

/// Uniform points of a triangle as barycentric coordinates (Turk 1990); the density is 1 / area.
template <class T>
Imath::Vec3<T> triangle(const Imath::Vec2<T>& u) {
    const T root = std::sqrt(u.x);
    const T second = root * (1 - u.y);
    return {1 - root, second, root - second};
}
template <class T>
Imath::Vec2<T> triangle_inverse(const Imath::Vec3<T>& b) {
    const T root = 1 - b.x;
    return {root * root, root > 0 ? 1 - b.y / root : T(0)};
}

} // namespace scree::warp
