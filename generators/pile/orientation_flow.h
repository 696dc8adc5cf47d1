// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/plane/field.h"

namespace scree {

/// A direction at every point of space, which components on a surface follow. All in the target's
/// frame.
class OrientationFlow {
  public:
    /// The same direction everywhere.
    static OrientationFlow constant(const Vec3& direction);
    /// Round an axis through `centre` [m], right-handed.
    static OrientationFlow swirl(const Vec3& axis, const Vec3& centre);
    /// Level, at the angle [deg] from +x towards +z that the field has at (x, z).
    static OrientationFlow heading(std::shared_ptr<const Field> angle);

    /// The flow turned about the surface's normal by the field's angle [deg] at (x, z).
    void set_turn(std::shared_ptr<const Field> turn) { turn_ = std::move(turn); }

    /// The unit tangent along the flow at a point of a surface with this unit normal. Where the
    /// flow is zero or at right angles to the surface, the tangent along the level line.
    Vec3 tangent(const Imath::V3d& position, const Vec3& normal) const;

  private:
    enum class Kind { constant, swirl, heading };
    OrientationFlow(Kind kind, const Vec3& direction) : kind_(kind), direction_(direction) {}

    Vec3 at(const Imath::V3d& position) const;

    Kind kind_;
    Vec3 direction_; // or the axis
    Vec3 centre_{0, 0, 0};
    std::shared_ptr<const Field> heading_;
    std::shared_ptr<const Field> turn_;
};

/// The horizontal unit tangent of a surface with this unit normal; x where the surface is level.
Vec3 level_line(const Vec3& normal);

} // namespace scree
