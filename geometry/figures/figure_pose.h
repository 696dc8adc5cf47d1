// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

namespace scree {

/// The difference of two angles, in [-pi, pi].
inline double angle_between(double a, double b) { return std::remainder(a - b, 2 * pi); }

/// Where an element lies: x = R S x0 + t, with x0 relative to the centre of its region's bounding
/// box (Sakurai & Miyata 2014, eq. 1).
struct FigurePose {
    Vec2 position;     // t [m]
    double angle = 0;  // [rad]
    double scale = 1;  // > 0
    double cosine = 1; // of the angle
    double sine = 0;

    FigurePose() = default;
    FigurePose(const Vec2& p, double a, double s)
        : position(p), angle(a), scale(s), cosine(std::cos(a)), sine(std::sin(a)) {}

    Vec2 apply(const Vec2& v) const {
        return position + Vec2(cosine * v.x - sine * v.y, sine * v.x + cosine * v.y) * scale;
    }
    Vec2 apply_inverse(const Vec2& v) const {
        const Vec2 d = (v - position) / scale;
        return {cosine * d.x + sine * d.y, cosine * d.y - sine * d.x};
    }
};

} // namespace scree
