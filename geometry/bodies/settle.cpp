// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/bodies/settle.h"

#include <algorithm>

namespace scree {

namespace {

using Vec3d = Imath::V3d;

// Lengths in radii of the body.
constexpr double first_step = 0.4;
constexpr double longest_step = 0.6;
constexpr double least_step = 0.03;   // if not even this leads lower, the body rests
constexpr int push_rounds = 5;        // in each step, out of all bodies in the way
constexpr double clearance = 0.002;   // by how much more than needed a push moves the body
constexpr double ground_memory = 0.3; // how far it may slide until the ground is looked up again

/// The plane that touches the ground below a body.
struct GroundPlane {
    Vec3d point;
    Vec3d normal;

    double height(const Vec3d& p) const { return (p - point).dot(normal); }
};

// From farther above, the direction from the nearest point of the ground is taken for the normal:
// at an edge or on a rough surface the normal there may point elsewhere.
GroundPlane ground_below(const NearestSurface& ground, const Vec3d& p, const Vec3& outwards,
                         double radius) {
    const NearestSurface::Point point = ground.nearest(p);
    Vec3d normal(point.normal.dot(outwards) < 0 ? -point.normal : point.normal);
    if (point.distance > 0.5 * radius) {
        const Vec3d from_point = (p - point.position) / point.distance;
        normal = from_point.dot(normal) < 0 ? -from_point : from_point;
    }
    return {point.position, normal};
}

/// The inverse of the inertia of a body of mass 1 about its origin.
Imath::M33d inverse_inertia(const Body& body) {
    Imath::M33d spread(0.0);
    double mass = 0;
    for (const Ball& ball : body.balls) {
        const double r = double(ball.radius);
        const double m = r * r * r;
        const Vec3d c(ball.centre);
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                spread[i][j] += m * (c[i] * c[j] + (i == j ? r * r / 5 : 0));
        mass += m;
    }
    const double trace = spread[0][0] + spread[1][1] + spread[2][2];
    Imath::M33d inertia;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            inertia[i][j] = ((i == j ? trace : 0) - spread[i][j]) / mass;
    return inertia.inverse();
}

Imath::M33f turned(const Imath::M33f& turn, const Vec3d& by) {
    const double angle = by.length();
    if (angle == 0)
        return turn;
    const Vec3d axis = by / angle;
    const double c = std::cos(angle);
    const double s = std::sin(angle);
    Imath::M33f out;
    for (int row = 0; row < 3; ++row) { // Rodrigues
        const Vec3d v(turn[row][0], turn[row][1], turn[row][2]);
        const Vec3d w = v * c + axis.cross(v) * s + axis * (axis.dot(v) * (1 - c));
        for (int k = 0; k < 3; ++k)
            out[row][k] = static_cast<float>(w[k]);
    }
    return out;
}

Imath::M33f orthonormal(const Imath::M33f& m) {
    Vec3d x(m[0][0], m[0][1], m[0][2]);
    Vec3d y(m[1][0], m[1][1], m[1][2]);
    x.normalize();
    y = (y - x * x.dot(y)).normalized();
    const Vec3d z = x.cross(y);
    const Vec3 a(x), b(y), c(z);
    return {a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z};
}

double angle_between(const Imath::M33f& a, const Imath::M33f& b) {
    double trace = 0;
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k)
            trace += double(a[i][k]) * double(b[i][k]);
    return std::acos(std::clamp((trace - 1) / 2, -1.0, 1.0));
}

/// Where two bodies are deepest in each other.
struct DeepContact {
    double depth = 0; // [m]
    Vec3d at;         // in the world [m]
    Vec3d normal;     // out of the one that stays
};

/// Another body that may be in the way.
struct Obstacle {
    const Body* body;
    Pose pose;
    double allowed;        // depth [m]
    double free_until = 0; // the length of motion [m] up to which it is known not to be in the way
};

class Settling {
  public:
    Settling(const PlacedBodies& bodies, const PlacedBody& start, const SettleSettings& settings,
             const NearestSurface& ground, const Imath::M33d& inverse_inertia)
        : body_(bodies.body(start)), settings_(settings), surface_(ground), start_(start),
          pose_(start.pose), inverse_inertia_(inverse_inertia), slide_(body_.reach) {
        bodies.hash.near(pose_.centre, body_.reach + slide_, [&](std::uint32_t index) {
            const PlacedBody& other = bodies.all[index];
            const Body& other_body = bodies.body(other);
            const double gap =
                (other.pose.centre - pose_.centre).length() - other_body.reach - body_.reach;
            obstacles_.push_back({&other_body, other.pose,
                                  allowed_depth(body_, other_body, settings.overlap),
                                  std::max(gap, 0.0)});
        });
        look_down();
    }

    PlacedBody run() {
        const double radius = body_.radius;
        const double lowest = -settings_.sink * radius;
        Pose rest = pose_;
        double height = ground_.height(pose_.centre);
        double step = first_step * radius;
        for (int n = 0; n < settings_.steps && step >= least_step * radius; ++n) {
            if (height - lowest < 0.01 * radius)
                break;
            const Vec3d down = ground_.normal * -std::min(step, height - lowest);
            move(down, Vec3d(0));
            const bool free = push_out(lowest);
            const double now = ground_.height(pose_.centre);
            if (free && now < height - least_step * radius / 2 && within_bounds()) {
                rest = pose_;
                look_down();
                height = ground_.height(pose_.centre);
                step = std::min(1.5 * step, longest_step * radius);
            } else {
                move_back(rest);
                step /= 2;
            }
        }
        return {start_.body, rest, Vec3(ground_.normal), ground_.height(rest.centre)};
    }

  private:
    bool within_bounds() const { return (pose_.centre - start_.pose.centre).length() <= slide_; }

    void look_down() {
        if ((pose_.centre - looked_from_).length() < ground_memory * body_.radius)
            return;
        looked_from_ = pose_.centre;
        ground_ = ground_below(surface_, pose_.centre, start_.normal, body_.radius);
    }

    void move(const Vec3d& by, const Vec3d& turn) {
        pose_.centre += by;
        pose_.world_from_body = turned(pose_.world_from_body, turn);
        moved_ += by.length() + turn.length() * body_.reach;
    }

    void move_back(const Pose& rest) {
        moved_ += (pose_.centre - rest.centre).length() +
                  angle_between(pose_.world_from_body, rest.world_from_body) * body_.reach;
        pose_ = rest;
    }

    /// Pushes the body out of all others; returns whether it is free of them in the end.
    bool push_out(double lowest) {
        for (int round = 0; round < push_rounds; ++round) {
            bool pushed = false;
            for (Obstacle& obstacle : obstacles_)
                pushed = push_out_of(obstacle) || pushed;
            if (!pushed) {
                pose_.world_from_body = orthonormal(pose_.world_from_body);
                return true;
            }
            const double below = lowest - ground_.height(pose_.centre);
            if (below > 0)
                move(ground_.normal * below, Vec3d(0));
        }
        return false;
    }

    bool push_out_of(Obstacle& obstacle) {
        if (moved_ < obstacle.free_until)
            return false;
        const auto allowed = static_cast<float>(obstacle.allowed);
        const float depth = depth_between(body_, pose_, *obstacle.body, obstacle.pose,
                                          allowed - static_cast<float>(2 * body_.radius));
        if (double(depth) <= obstacle.allowed) {
            obstacle.free_until = moved_ + (obstacle.allowed - double(depth));
            return false;
        }
        push(deepest_contact(obstacle),
             settings_.overlap * std::min(body_.radius, obstacle.body->radius) -
                 clearance * body_.radius);
        return true;
    }

    void push(const DeepContact& contact, double depth_left) {
        const double depth = contact.depth - depth_left;
        const Vec3d lever = contact.at - pose_.centre;
        const Vec3d moment = lever.cross(contact.normal);
        const Vec3d turn = applied_inverse_inertia(moment);
        const double weight = 1 + moment.dot(turn);
        const Vec3d by = turn * (depth / weight);
        if (settings_.turn > 0 && angle_between(turned(pose_.world_from_body, by),
                                                start_.pose.world_from_body) <= settings_.turn)
            move(contact.normal * (depth / weight), by);
        else
            move(contact.normal * depth, Vec3d(0));
    }

    Vec3d applied_inverse_inertia(const Vec3d& world) const {
        const Imath::M33d m(pose_.world_from_body);
        return world * m.transposed() * inverse_inertia_ * m;
    }

    DeepContact deepest_contact(const Obstacle& obstacle) const {
        const Body& other = *obstacle.body;
        DeepContact deepest;
        const bool own_is_fine = body_.radius <= other.radius;
        if (own_is_fine || !other.probe_fills)
            deepest = probe_contact(body_, pose_, other, obstacle.pose);
        if (!own_is_fine || !body_.probe_fills) {
            DeepContact back = probe_contact(other, obstacle.pose, body_, pose_);
            back.normal = -back.normal;
            if (back.depth > deepest.depth)
                deepest = back;
        }
        return deepest;
    }

    // Of the probe of the first in the second; the normal points out of the second.
    static DeepContact probe_contact(const Body& a, const Pose& pose_a, const Body& b,
                                     const Pose& pose_b) {
        const RelativePose there = relative(pose_a, pose_b);
        const BallTree::Deepest deepest =
            a.probe.deepest_where([&](const Vec3& p) { return b.distance.at(there(p)); });
        const Vec3 in_b = there(deepest.ball.centre);
        Vec3 gradient;
        b.distance.at(in_b, gradient);
        const Vec3 normal = gradient.length() > 0 ? gradient.normalized() : Vec3(0, 1, 0);
        return {double(deepest.depth),
                pose_b.centre +
                    Vec3d((in_b - normal * deepest.ball.radius) * pose_b.world_from_body),
                Vec3d(normal * pose_b.world_from_body)};
    }

    const Body& body_;
    const SettleSettings& settings_;
    const NearestSurface& surface_;
    const PlacedBody start_;
    Pose pose_;
    Imath::M33d inverse_inertia_;
    double slide_;     // how far from its start it may get [m]
    double moved_ = 0; // an upper bound of the length of the path of any of its points [m]
    GroundPlane ground_;
    Vec3d looked_from_{std::numeric_limits<double>::max(), 0, 0};
    std::vector<Obstacle> obstacles_;
};

} // namespace

Settler::Settler(const Bodies& bodies, const Mesh& ground, const SettleSettings& settings)
    : settings_(settings), ground_(ground) {
    for (const auto& body : bodies)
        inverse_inertias_.push_back(inverse_inertia(*body));
}

PlacedBody Settler::settle(const PlacedBodies& bodies, const PlacedBody& start) const {
    return Settling(bodies, start, settings_, ground_, inverse_inertias_[start.body]).run();
}

} // namespace scree
