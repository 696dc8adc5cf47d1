// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/bodies/settle.h"

#include "geometry/bodies/push.h"

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
             const NearestSurface& ground, const MassProperties& mass)
        : body_(bodies.body(start)), settings_(settings), surface_(ground), start_(start),
          pose_(start.pose), mass_(mass), slide_(body_.reach) {
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
            move(ground_.normal * -std::min(step, height - lowest));
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

    void move(const Vec3d& by) {
        pose_.centre += by;
        moved_ += by.length();
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
            if (!pushed)
                return true;
            const double below = lowest - ground_.height(pose_.centre);
            if (below > 0)
                move(ground_.normal * below);
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
        push(contact_with(obstacle),
             settings_.overlap * std::min(body_.radius, obstacle.body->radius) -
                 clearance * body_.radius);
        return true;
    }

    void push(const DeepContact& contact, double depth_left) {
        const double depth = contact.depth - depth_left;
        const PushResponse response(mass_, pose_, contact.point, contact.normal);
        const double by = depth / response.compliance();
        const Pose pushed = response.pushed(by);
        if (settings_.turn == 0 ||
            angle_between(pushed.world_from_body, start_.pose.world_from_body) > settings_.turn) {
            move(contact.normal * depth);
            return;
        }
        const double arm = body_.reach + double(mass_.centre.length());
        moved_ += std::abs(by) * (response.shift() + response.turn() * arm);
        pose_ = pushed;
    }

    /// The deepest contact with the obstacle; its normal points out of the obstacle.
    DeepContact contact_with(const Obstacle& obstacle) const {
        const Body& other = *obstacle.body;
        DeepContact deepest;
        const bool own_is_fine = body_.radius <= other.radius;
        if (own_is_fine || !other.probe_fills)
            deepest = deepest_contact(body_, pose_, other, obstacle.pose);
        if (!own_is_fine || !body_.probe_fills) {
            DeepContact back = deepest_contact(other, obstacle.pose, body_, pose_);
            back.normal = -back.normal;
            if (back.depth > deepest.depth)
                deepest = back;
        }
        return deepest;
    }

    const Body& body_;
    const SettleSettings& settings_;
    const NearestSurface& surface_;
    const PlacedBody start_;
    Pose pose_;
    const MassProperties& mass_;
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
        masses_.push_back(mass_properties(*body));
}

PlacedBody Settler::settle(const PlacedBodies& bodies, const PlacedBody& start) const {
    return Settling(bodies, start, settings_, ground_, masses_[start.body]).run();
}

} // namespace scree
