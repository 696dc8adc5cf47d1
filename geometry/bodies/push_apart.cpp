// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/bodies/push_apart.h"

#include <algorithm>

namespace scree {

namespace {

// How far one contact may move a body at once, in radii, and turn it [rad]: the normal of a deep
// contact is valid only near by.
constexpr double most_shift = 0.5;
constexpr double most_turn = 0.3;

Imath::V3d turned(const Imath::V3d& v, const Imath::V3d& axis, double c, double s) {
    return v * c + axis.cross(v) * s + axis * (axis.dot(v) * (1 - c));
}

/// How a body moves when it is pushed at one of its points.
class PushResponse {
  public:
    PushResponse(MovingBody& body, const Imath::V3d& point, const Imath::V3d& direction)
        : body_(body),
          centre_(body.pose.centre + Imath::V3d(body.mass->centre * body.pose.world_from_body)) {
        const Imath::M33d turn = matrix();
        const Imath::V3d arm = (point - centre_).cross(direction);
        turn_ = arm * turn.transposed() * body.mass->inverse_inertia * turn;
        shift_ = direction / body.mass->mass;
        compliance_ = 1 / body.mass->mass + arm.dot(turn_);
    }

    double compliance() const { return compliance_; } // how far the point moves by a push of 1

    double most() const {
        const double shift = most_shift * body_.body->radius / shift_.length();
        return turn_.length() > 0 ? std::min(shift, most_turn / turn_.length()) : shift;
    }

    void push(double by) {
        const double angle = turn_.length() * std::abs(by);
        const Imath::V3d centre = centre_ + shift_ * by;
        Imath::V3d origin = body_.pose.centre - centre_;
        if (angle > 1e-9) {
            const Imath::V3d axis = (turn_ * by).normalized();
            const double c = std::cos(angle);
            const double s = std::sin(angle);
            origin = turned(origin, axis, c, s);
            const Imath::M33d m = matrix();
            // Made a rotation anew, so that rounding does not add up.
            const Imath::V3d x = turned({m[0][0], m[0][1], m[0][2]}, axis, c, s).normalized();
            Imath::V3d y = turned({m[1][0], m[1][1], m[1][2]}, axis, c, s);
            y = (y - x * x.dot(y)).normalized();
            const Imath::V3d z = x.cross(y);
            body_.pose.world_from_body =
                Imath::M33f(Imath::M33d(x.x, x.y, x.z, y.x, y.y, y.z, z.x, z.y, z.z));
        }
        body_.pose.centre = centre + origin;
    }

  private:
    Imath::M33d matrix() const { return Imath::M33d(body_.pose.world_from_body); }

    MovingBody& body_;
    Imath::V3d centre_; // of mass
    Imath::V3d shift_;  // by a push of 1 [m]
    Imath::V3d turn_;   // by a push of 1, as a rotation vector [rad]
    double compliance_ = 0;
};

/// Pushes apart the two bodies where a ball of a's probe is deepest in b. Returns how deep it was
/// [m], or `allowed` if it was no deeper.
double push_out(MovingBody& a, MovingBody& b, double allowed) {
    const RelativePose there = relative(a.pose, b.pose);
    const BallTree::Deepest deepest = a.body->probe.deepest_where(
        [&](const Vec3& p) { return b.body->distance.at(there(p)); }, static_cast<float>(allowed));
    const double depth = double(deepest.depth);
    if (depth <= allowed)
        return allowed;
    Vec3 gradient;
    b.body->distance.at(there(deepest.ball.centre), gradient);
    Imath::V3d normal(gradient * b.pose.world_from_body);
    if (normal.length() < 0.1) // on the medial axis
        normal = a.pose.centre - b.pose.centre;
    normal = normal.length() > 0 ? normal.normalized() : Imath::V3d(0, 1, 0);
    const Imath::V3d point = a.pose.centre +
                             Imath::V3d(deepest.ball.centre * a.pose.world_from_body) -
                             normal * (double(deepest.ball.radius) - depth / 2);
    PushResponse response_a(a, point, normal);
    PushResponse response_b(b, point, -normal);
    const double by =
        std::min({(depth - allowed) / (response_a.compliance() + response_b.compliance()),
                  response_a.most(), response_b.most()});
    response_a.push(by);
    response_b.push(by);
    return depth;
}

} // namespace

double push_apart(MovingBody& a, MovingBody& b, double allowed) {
    return std::max(push_out(a, b, allowed), push_out(b, a, allowed));
}

} // namespace scree
