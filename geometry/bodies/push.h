// SPDX-License-Identifier: GPL-3.0-or-later
// Position-based dynamics of rigid bodies without compliance (Mueller et al. 2020, eq. 2 to 9): a
// contact moves and turns bodies at once by as much as makes it as deep as wanted.
#pragma once

#include "geometry/bodies/mass_properties.h"

#include <limits>

namespace scree {

/// The deepest contact of one body's probe with another body, in the world's frame.
struct DeepContact {
    double depth = std::numeric_limits<double>::lowest(); // [m]
    Imath::V3d point{0.0, 0.0, 0.0};                      // in the middle of the overlap [m]
    Imath::V3d normal{0.0, 1.0, 0.0};                     // of length 1, out of the other body
};

/// Where a ball of a's probe is deepest in b. If none is deeper than `floor` [m], a contact of that
/// depth at no particular place.
DeepContact deepest_contact(const Body& a, const Pose& pose_a, const Body& b, const Pose& pose_b,
                            float floor = std::numeric_limits<float>::lowest());

/// How a body moves when it is pushed at a point of the world in a direction of length 1.
class PushResponse {
  public:
    PushResponse(const MassProperties& mass, const Pose& pose, const Imath::V3d& point,
                 const Imath::V3d& direction);

    /// How far a push of 1 moves the point along the direction.
    double compliance() const { return compliance_; }
    /// How far a push of 1 moves the centre of mass.
    double shift() const { return shift_.length(); }
    /// By what angle a push of 1 turns the body [rad].
    double turn() const { return turn_.length(); }

    /// The pose after a push of `by`.
    Pose pushed(double by) const;

  private:
    Pose pose_;
    Imath::V3d mass_centre_; // in the world [m]
    Imath::V3d shift_;       // of the centre of mass by a push of 1
    Imath::V3d turn_;        // by a push of 1, as a rotation vector [rad]
    double compliance_ = 0;
};

/// A body that can be moved.
struct MovingBody {
    const Body* body = nullptr;
    const MassProperties* mass = nullptr;
    Pose pose;
};

/// Moves and turns two bodies, according to their masses and inertias, until their deepest contact
/// is `allowed` [m] deep. Returns how deep they were [m], or `allowed` if they were no deeper.
double push_apart(MovingBody& a, MovingBody& b, double allowed);

} // namespace scree
