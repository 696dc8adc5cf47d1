// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/rock/rock_body.h"

#include "geometry/rock/solid_noise.h"

#include <algorithm>

namespace scree {

namespace {

constexpr double sharpest = 40;  // the exponent without wear: edges as of a fresh fragment
constexpr double roundest = 3.2; // and at full wear
// From this wear on faces round off too, until at full wear the body is so much of an ellipsoid.
constexpr double rounded_from = 0.3;
constexpr double most_rounded = 0.7;
constexpr double ellipsoid = 0.8; // its radius before the axes are scaled, where a body's mean is
constexpr double least_radius = 0.2;
constexpr double neglected = 6; // planes whose share of the gauge's sum is below e^-6 are left out

double standard_normal(Random& random) { // Box & Muller 1958
    const double radius = std::sqrt(-2 * std::log(1 - random.uniform()));
    return radius * std::cos(2 * pi * random.uniform());
}

/// How far the second phase of abrasion has come, in which the whole surface wears.
double rounded_by(double wear) {
    const double t = std::clamp((wear - rounded_from) / (1 - rounded_from), 0.0, 1.0);
    return most_rounded * t * t * (3 - 2 * t);
}

} // namespace

WideVec3 random_direction(Random& random) {
    const double z = random.uniform(-1, 1);
    const double angle = 2 * pi * random.uniform();
    const double r = std::sqrt(std::max(0.0, 1 - z * z));
    return {r * std::cos(angle), r * std::sin(angle), z};
}

WideVec3 normal_vector(Random& random) {
    WideVec3 v;
    for (int axis = 0; axis < 3; ++axis)
        v[axis] = standard_normal(random);
    return v;
}

RockBody::RockBody(const RockSettings& settings, Random& random, std::vector<RockPlane> cut)
    : wear_(settings.wear), exponent_(roundest * std::pow(sharpest / roundest, 1 - settings.wear)),
      rounded_(cut.empty() ? rounded_by(settings.wear) : 0), noise_(random.bits()),
      planes_(std::move(cut)) {
    add_faces(settings, random);
    add_chips(settings, random);
    add_scars(settings, random);
}

void RockBody::add_faces(const RockSettings& settings, Random& random) {
    // Joints are nearly perpendicular to each other and to the axes.
    joints_[0] = (WideVec3(1, 0, 0) + 0.25 * normal_vector(random)).normalized();
    joints_[1] = joints_[0].cross(WideVec3(0, 0, 1) + 0.2 * normal_vector(random)).normalized();
    joints_[2] = joints_[0].cross(joints_[1]);
    // Half-spaces that cut the body from outside are to be seen: its own faces leave them room.
    const double room = planes_.empty() ? 1 : 1.25;
    const int wanted = std::max(static_cast<int>(std::floor(settings.faces + random.uniform())), 4);
    for (int i = 0; i < std::min(wanted, 6); ++i) {
        const WideVec3 normal = joints_[std::size_t(i / 2)] * (i % 2 == 0 ? 1 : -1);
        planes_.push_back({(normal + settings.scatter * normal_vector(random)).normalized(),
                           room * random.uniform(0.62, 1.0)});
    }
    for (int i = 6; i < wanted; ++i)
        planes_.push_back({random_direction(random), room * random.uniform(0.62, 0.95)});
    for (int axis = 0; axis < 3; ++axis) // bounds the body where the joints leave it open
        for (const double side : {-1.0, 1.0}) {
            WideVec3 normal(0, 0, 0);
            normal[axis] = side;
            planes_.push_back({normal, 1.12 * room});
        }
}

WideVec3 RockBody::protruding(Random& random, int tries) const {
    WideVec3 best(0, 0, 1);
    double least = std::numeric_limits<double>::max();
    for (int i = 0; i < tries; ++i) {
        const WideVec3 direction = random_direction(random);
        if (const double gauge = sharp_gauge(direction); gauge < least) {
            least = gauge;
            best = direction;
        }
    }
    return best;
}

void RockBody::add_chips(const RockSettings& settings, Random& random) {
    for (int i = 0; i < settings.chips; ++i) {
        const WideVec3 corner = protruding(random, 4);
        const double radius = 1 / sharp_gauge(corner);
        const WideVec3 normal = (corner + 0.3 * normal_vector(random)).normalized();
        // Many small chips and few large ones.
        const double depth = (1 - 0.8 * wear_) * 0.06 * -std::log(1 - 0.95 * random.uniform());
        planes_.push_back({normal, std::max(0.3, radius * (normal ^ corner) * (1 - depth)),
                           random.uniform(0.8, 2.2 - 1.2 * wear_)});
    }
}

void RockBody::add_scars(const RockSettings& settings, Random& random) {
    // Balls much larger than the rock, at its corners: smaller ones look like thumbprints.
    for (int i = 0; i < settings.scars; ++i) {
        const WideVec3 corner = protruding(random, 3);
        const double radius = 1 / sharp_gauge(corner);
        const double ball = random.uniform(0.9, 3.2);
        const double depth = radius * random.uniform(0.02, 0.09) * (1 - 0.8 * wear_);
        scars_.push_back({corner * (radius + ball - depth) + 0.2 * normal_vector(random), ball});
    }
}

double RockBody::sharp_gauge(const WideVec3& direction) const {
    double largest = 1e-3;
    for (const RockPlane& plane : planes_)
        largest = std::max(largest, (plane.normal ^ direction) / plane.height);
    return largest;
}

double RockBody::gauge(const WideVec3& direction, double exponent) const {
    const double largest = sharp_gauge(direction);
    const double least = largest * std::exp(-neglected / exponent);
    double sum = 0;
    for (const RockPlane& plane : planes_) {
        const double ratio = (plane.normal ^ direction) / plane.height;
        if (ratio > least)
            sum += std::exp(plane.sharpness * exponent * std::log(ratio / largest));
    }
    return largest * std::pow(std::max(1.0, sum), 1 / exponent);
}

double RockBody::hollowed(const WideVec3& direction, double radius) const {
    const double blend = 0.004 + 0.1 * wear_;
    for (const Scar& scar : scars_) {
        const double along = direction ^ scar.centre;
        const double inside = along * along - scar.centre.length2() + scar.radius * scar.radius;
        if (inside <= 0 || along < 0)
            continue;
        const double enters = along - std::sqrt(inside);
        if (enters > radius + blend)
            continue;
        const double t = std::clamp(0.5 + 0.5 * (radius - enters) / blend, 0.0, 1.0);
        radius = mix(radius, enters, t) - blend * t * (1 - t);
    }
    return radius;
}

double RockBody::radius(const WideVec3& direction) const {
    // Faces curve a little, and more so where the rock is fresh.
    const WideVec3 bent = (direction + 0.10 * vector_noise(1.3 * direction, noise_) +
                           0.035 * (1 - 0.9 * wear_) * vector_noise(3.1 * direction, noise_ + 9))
                              .normalized();
    const double local =
        exponent_ * std::exp(0.7 * (1 - 0.7 * wear_) * gradient_noise(1.9 * direction, noise_ + 3));
    return std::max(least_radius, mix(hollowed(bent, 1 / gauge(bent, local)), ellipsoid, rounded_));
}

} // namespace scree
