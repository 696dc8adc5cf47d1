// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

#include <array>
#include <cstdint>

namespace scree::rocks {

/// A triangle seen from above, counter-clockwise in (x, z): its plane as a height.
struct Plan {
    Plan(const WideVec3& a, const WideVec3& b, const WideVec3& c);

    double height(double x, double z) const {
        return corners[0].y + slope_x * (x - corners[0].x) + slope_z * (z - corners[0].z);
    }

    std::array<WideVec3, 3> corners;
    double slope_x = 0; // of the height along x
    double slope_z = 0;
    double low = 0; // the least and the greatest height
    double high = 0;
    Imath::Box2f box; // (x, z)
};

/// No less than how far the one triangle is above the other where both are seen; infinite if they
/// are beside each other.
double least_between(const Plan& upper, const Plan& lower);

/// What two triangles have in common, seen from above (Sutherland & Hodgman 1974), with what its
/// corners come from.
struct CommonArea {
    struct Corner {
        Vec2 place;
        int side = 0;  // that begins here: 0 to 2 of the first triangle, 3 to 5 of the second
        int other = 0; // that ends here
    };

    CommonArea(const Plan& a, const Plan& b);

    std::array<Corner, 9> corners;
    std::size_t count = 0;

  private:
    /// Leaves of it what is on the left of a line.
    void clip(const Vec2& from, const Vec2& to, int line);
};

} // namespace scree::rocks
