// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/params.h"
#include "geometry/plane/field.h"

namespace scree {

/// A direction at every point of space, along which components are laid on a surface.
class OrientationFlow {
  public:
    /// The same direction everywhere.
    static OrientationFlow constant(const Vec3& direction);
    /// Round an axis, right-handed.
    static OrientationFlow swirl(const Vec3& axis, const Vec3& centre);
    /// Level, at the angle [deg] from +x towards +z that the field has at (x, z).
    static OrientationFlow heading(std::shared_ptr<const Field> angle);

    /// The flow turned about the surface's normal by the field's angle [deg] at (x, z).
    void set_turn(std::shared_ptr<const Field> turn) { turn_ = std::move(turn); }

    /// Its unit tangent on a surface with this unit normal; where the flow is at right angles to
    /// the surface or ceases, that along the level line, or, where there is none, along x.
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

/// Along the surface's level line, or, where it is level all over, along x.
Vec3 level_line(const Vec3& normal);

/// The fields of a flow's record, and what they make. Throws Error unless it is one kind of flow.
std::vector<ParamSpec> flow_specs();
OrientationFlow orientation_flow(const Params& params);

} // namespace scree
