// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

namespace scree {

/// Position and rotation of a rigid body.
struct Pose {
    Imath::V3d centre{0.0, 0.0, 0.0}; // of the largest inner ball: the body's origin [m]
    Imath::M33f world_from_body;      // a rotation; its rows are the images of the body's axes
};

/// A rotation by a vector: about its direction, right-handed, by its length [rad].
class Rotation {
  public:
    explicit Rotation(const Imath::V3d& vector);

    Imath::V3d operator()(const Imath::V3d& v) const;
    /// The rows of a rotation matrix turned, and made orthonormal again, so that rounding does not
    /// add up.
    Imath::M33f operator()(const Imath::M33f& rows) const;

  private:
    Imath::V3d axis_{0.0, 0.0, 0.0};
    double cosine_ = 1;
    double sine_ = 0;
};

/// The angle of the rotation that leads from one orientation to another [rad].
double angle_between(const Imath::M33f& a, const Imath::M33f& b);

/// The rigid motion that takes one body's frame to another's.
struct RelativePose {
    Imath::M33f rotation;
    Vec3 offset;

    Vec3 operator()(const Vec3& p) const { return p * rotation + offset; }
};

/// The motion that takes points of `from`'s frame to `to`'s.
inline RelativePose relative(const Pose& from, const Pose& to) {
    const Imath::M33f to_from_world = to.world_from_body.transposed();
    return {from.world_from_body * to_from_world, Vec3(from.centre - to.centre) * to_from_world};
}

/// The matrix that places a mesh whose point `origin` is the body's origin.
inline Matrix world_from_object(const Pose& pose, const Vec3& origin) {
    const Imath::M33f& m = pose.world_from_body;
    const Vec3 at(pose.centre - Imath::V3d(origin * m));
    return {m[0][0], m[0][1], m[0][2], 0, m[1][0], m[1][1], m[1][2], 0,
            m[2][0], m[2][1], m[2][2], 0, at.x,    at.y,    at.z,    1};
}

} // namespace scree
