// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/pile/orientation_flow.h"

namespace scree {

namespace {

// The sine of the angle to the normal below which rounding decides the projection's direction.
constexpr float least_projection = 1e-4F;

Vec2 ground(const Imath::V3d& position) { return {position.x, position.z}; }

} // namespace

OrientationFlow OrientationFlow::constant(const Vec3& direction) {
    return {Kind::constant, direction.normalized()};
}

OrientationFlow OrientationFlow::swirl(const Vec3& axis, const Vec3& centre) {
    OrientationFlow flow(Kind::swirl, axis.normalized());
    flow.centre_ = centre;
    return flow;
}

OrientationFlow OrientationFlow::heading(std::shared_ptr<const Field> angle) {
    OrientationFlow flow(Kind::heading, Vec3(0));
    flow.heading_ = std::move(angle);
    return flow;
}

Vec3 OrientationFlow::at(const Imath::V3d& position) const {
    switch (kind_) {
    case Kind::constant:
        return direction_;
    case Kind::swirl:
        return direction_.cross(Vec3(position - Imath::V3d(centre_))).normalized();
    case Kind::heading: {
        const double angle = radians(heading_->at(ground(position)));
        return {static_cast<float>(std::cos(angle)), 0, static_cast<float>(std::sin(angle))};
    }
    }
    return {};
}

Vec3 OrientationFlow::tangent(const Imath::V3d& position, const Vec3& normal) const {
    const Vec3 flow = at(position);
    Vec3 tangent = flow - normal * normal.dot(flow);
    tangent = tangent.length() > least_projection ? tangent.normalized() : level_line(normal);
    if (turn_) {
        const double angle = radians(turn_->at(ground(position)));
        tangent = tangent * static_cast<float>(std::cos(angle)) +
                  normal.cross(tangent) * static_cast<float>(std::sin(angle));
    }
    return tangent;
}

Vec3 level_line(const Vec3& normal) {
    const Vec3 u = Vec3(0, 1, 0).cross(normal);
    return u.length() > 1e-4F ? u.normalized() : Vec3(1, 0, 0);
}

} // namespace scree
