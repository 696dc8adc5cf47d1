// SPDX-License-Identifier: GPL-3.0-or-later
// Unit quaternions as the frames of fibres' segments, whose y axes lie along the segments.
#pragma once

#include "core/math.h"
#include "core/random.h"

#include <ImathQuat.h>

namespace scree::fibres {

using Rotation = Imath::Quatf; // r: cosine of half the angle; v: the axis times its sine

inline Rotation unit(const Rotation& q) {
    const float scale = 1 / std::sqrt(q.r * q.r + q.v.dot(q.v));
    return {q.r * scale, q.v * scale};
}

/// The image of (0, 1, 0).
inline Vec3 axis_y(const Rotation& q) {
    const Vec3& v = q.v;
    return {2 * (v.x * v.y - q.r * v.z), q.r * q.r - v.x * v.x + v.y * v.y - v.z * v.z,
            2 * (v.y * v.z + q.r * v.x)};
}

/// The image of any vector.
inline Vec3 rotated(const Rotation& q, const Vec3& p) {
    const Vec3 t = q.v.cross(p) * 2.0F;
    return p + t * q.r + q.v.cross(t);
}

inline Rotation about_y(float angle) {
    return {std::cos(angle / 2), Vec3(0, std::sin(angle / 2), 0)};
}

inline Rotation about_z(float angle) {
    return {std::cos(angle / 2), Vec3(0, 0, std::sin(angle / 2))};
}

/// The shortest rotation that takes one unit vector to another.
inline Rotation from_to(const Vec3& a, const Vec3& b) {
    const float c = 1 + a.dot(b);
    if (c > 1e-6F)
        return unit({c, a.cross(b)});
    const Vec3 side = std::abs(a.x) < 0.5F ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    return {0, a.cross(side).normalized()};
}

/// The frame turned so that its y axis goes a `share` of the angle towards a unit vector.
inline Rotation turned_towards(const Rotation& frame, const Vec3& direction, double share) {
    const Rotation whole = from_to(axis_y(frame), direction);
    const float half = std::acos(std::min(whole.r, 1.0F));
    const float sine = std::sin(half);
    if (sine < 1e-6F)
        return frame;
    const float part = half * static_cast<float>(share);
    return unit(Rotation(std::cos(part), whole.v * (std::sin(part) / sine)) * frame);
}

/// Uniform over all rotations (Shoemake 1992).
inline Rotation random_rotation(Random& random) {
    const float u = random.uniform_float();
    const float a = 2 * pi_f * random.uniform_float();
    const float b = 2 * pi_f * random.uniform_float();
    const float low = std::sqrt(1 - u);
    const float high = std::sqrt(u);
    return {high * std::cos(b), Vec3(low * std::sin(a), low * std::cos(a), high * std::sin(b))};
}

} // namespace scree::fibres
