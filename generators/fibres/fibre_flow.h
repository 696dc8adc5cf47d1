// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/plane/field.h"

namespace scree::fibres {

/// A direction at every point, by its place on the ground.
struct FibreFlow {
    std::shared_ptr<const Field> heading; // [deg], from +x towards +z
    std::shared_ptr<const Field> rise;    // above level [deg]; null: none
    double strength = 0.5;                // share of the angle that a segment turns towards it

    /// Of length 1.
    Vec3 at(const Vec3& p) const {
        const Vec2 ground(p.x, p.z);
        const double h = radians(heading->at(ground));
        const double up = rise ? radians(rise->at(ground)) : 0;
        return Vec3(WideVec3(std::cos(h) * std::cos(up), std::sin(up), std::sin(h) * std::cos(up)));
    }
};

} // namespace scree::fibres
