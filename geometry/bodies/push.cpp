// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/bodies/push.h"

#include <algorithm>

namespace scree {

namespace {

// How far one contact may move a body at once, in radii, and turn it [rad]: the normal of a deep
// contact is valid only near by.
constexpr double most_shift = 0.5;
constexpr double most_turn = 0.3;

double largest_push(const PushResponse& response, double radius) {
    const double shift = most_shift * radius / response.shift();
    return response.turn() > 0 ? std::min(shift, most_turn / response.turn()) : shift;
}

/// Pushes apart the two bodies where a ball of a's probe is deepest in b. Returns how deep it was
/// [m], or `allowed` if it was no deeper.
double push_out(MovingBody& a, MovingBody& b, double allowed) {
    const DeepContact contact =
        deepest_contact(*a.body, a.pose, *b.body, b.pose, static_cast<float>(allowed));
    if (contact.depth <= allowed)
        return allowed;
    const PushResponse response_a(*a.mass, a.pose, contact.point, contact.normal);
    const PushResponse response_b(*b.mass, b.pose, contact.point, -contact.normal);
    const double by = std::min(
        {(contact.depth - allowed) / (response_a.compliance() + response_b.compliance()),
         largest_push(response_a, a.body->radius), largest_push(response_b, b.body->radius)});
    a.pose = response_a.pushed(by);
    b.pose = response_b.pushed(by);
    return contact.depth;
}

} // namespace

DeepContact deepest_contact(const Body& a, const Pose& pose_a, const Body& b, const Pose& pose_b,
                            float floor) {
    const RelativePose there = relative(pose_a, pose_b);
    const BallTree::Deepest deepest =
        a.probe.deepest_where([&](const Vec3& p) { return b.distance.at(there(p)); }, floor);
    DeepContact contact;
    contact.depth = double(deepest.depth);
    if (deepest.depth <= floor)
        return contact;
    Vec3 gradient;
    b.distance.at(there(deepest.ball.centre), gradient);
    Imath::V3d normal(gradient * pose_b.world_from_body);
    if (normal.length() < 0.1) // on the medial axis
        normal = pose_a.centre - pose_b.centre;
    if (normal.length() > 0)
        contact.normal = normal.normalized();
    contact.point = pose_a.centre + Imath::V3d(deepest.ball.centre * pose_a.world_from_body) -
                    contact.normal * (double(deepest.ball.radius) - contact.depth / 2);
    return contact;
}

PushResponse::PushResponse(const MassProperties& mass, const Pose& pose, const Imath::V3d& point,
                           const Imath::V3d& direction)
    : pose_(pose), mass_centre_(pose.centre + Imath::V3d(mass.centre * pose.world_from_body)),
      shift_(direction / mass.mass) {
    const Imath::M33d world_from_body(pose.world_from_body);
    const Imath::V3d arm = (point - mass_centre_).cross(direction);
    turn_ = arm * world_from_body.transposed() * mass.inverse_inertia * world_from_body;
    compliance_ = 1 / mass.mass + arm.dot(turn_);
}

Pose PushResponse::pushed(double by) const {
    const Rotation rotation(turn_ * by);
    return {mass_centre_ + shift_ * by + rotation(pose_.centre - mass_centre_),
            rotation(pose_.world_from_body)};
}

double push_apart(MovingBody& a, MovingBody& b, double allowed) {
    return std::max(push_out(a, b, allowed), push_out(b, a, allowed));
}

} // namespace scree
