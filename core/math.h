// SPDX-License-Identifier: GPL-3.0-or-later
// Vectors, matrices and the few numeric helpers that every folder shares.
#pragma once

#include <ImathBox.h>
#include <ImathColor.h>
#include <ImathMatrix.h>
#include <ImathVec.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace scree {

using Vec2 = Imath::V2d; // layout plane: double, since exclusion tests must be safe
using Vec2f = Imath::V2f;
using Vec3 = Imath::V3f;
using Ring = std::vector<Vec2>; // a closed polygon without its repeated last point [m]
using Box2 = Imath::Box2d;
using Box3 = Imath::Box3f;
using Color = Imath::C3f; // linear Rec. 709

// Imath multiplies row vectors: p_world = p_object * world_from_object, so the rows of the matrix
// are the images of the object's axes and its last row is the translation.
using Matrix = Imath::M44f;

inline constexpr double pi = std::numbers::pi;
inline constexpr float pi_f = std::numbers::pi_v<float>;

constexpr double radians(double degrees) { return degrees * (pi / 180.0); }
constexpr double degrees(double radians) { return radians * (180.0 / pi); }

inline Vec2 rotate(const Vec2& v, double angle) {
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    return {c * v.x - s * v.y, s * v.x + c * v.y};
}

inline double cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

/// The same in double, where things may lie far from the origin.
using WideMatrix = Imath::M44d;
using WideVec3 = Imath::V3d;

inline Vec3 transform_point(const Matrix& a_from_b, const Vec3& p) { return p * a_from_b; }

inline Vec3 transform_direction(const Matrix& a_from_b, const Vec3& d) {
    Vec3 out;
    a_from_b.multDirMatrix(d, out);
    return out;
}

inline Vec3 transform_point(const WideMatrix& a_from_b, const Vec3& p) {
    return Vec3(WideVec3(p) * a_from_b);
}

inline Vec3 transform_direction(const WideMatrix& a_from_b, const Vec3& d) {
    return transform_direction(Matrix(a_from_b), d);
}

inline bool is_finite(const Vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

inline float luminance(const Color& c) { // ITU-R BT.709
    return 0.2126F * c.x + 0.7152F * c.y + 0.0722F * c.z;
}

} // namespace scree
