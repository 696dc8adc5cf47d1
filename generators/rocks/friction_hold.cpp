// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/rocks/friction_hold.h"

#include <algorithm>
#include <vector>

namespace scree::rocks {

namespace {

constexpr double friction = 0.7; // tan(35 degrees)
constexpr double enough = 0.03;  // of the weight
constexpr int most_sweeps = 60;
constexpr int sweeps_between_looks = 4;
constexpr double least_progress = 0.9; // what is missing falls to this or less between two looks
constexpr int directions = 12;         // in which the outermost contacts are looked for

/// A force and its torque about the centre of mass.
using Wrench = std::array<double, 6>;

double dot(const Wrench& a, const Wrench& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += a[i] * b[i];
    return sum;
}

Wrench wrench_of(const WideVec3& force, const WideVec3& arm) {
    const WideVec3 torque = arm.cross(force);
    return {force.x, force.y, force.z, torque.x, torque.y, torque.z};
}

/// Four edges of the cone's pyramid, and its axis.
void add_cone(const Gap& contact, double reach, std::vector<Wrench>& out) {
    const WideVec3 normal = contact.normal;
    const WideVec3 arm = contact.arm / reach;
    const WideVec3 other = std::abs(normal.x) < 0.7 ? WideVec3(1, 0, 0) : WideVec3(0, 0, 1);
    const WideVec3 u = normal.cross(other).normalized();
    const WideVec3 v = normal.cross(u);
    out.push_back(wrench_of(normal, arm));
    for (const WideVec3& t : {u, -u, v, -v})
        out.push_back(wrench_of(normal + friction * t, arm));
}

/// The contacts that are outermost in some direction: others hardly add to what they can bear.
std::vector<const Gap*> outermost(std::span<const Gap> contacts) {
    std::vector<const Gap*> out;
    for (int k = 0; k < directions; ++k) {
        const double angle = 2 * pi * k / directions;
        const Vec2 towards(std::cos(angle), std::sin(angle));
        const auto far =
            std::max_element(contacts.begin(), contacts.end(), [&](const Gap& a, const Gap& b) {
                return a.arm.x * towards.x + a.arm.z * towards.y <
                       b.arm.x * towards.x + b.arm.z * towards.y;
            });
        if (std::find(out.begin(), out.end(), &*far) == out.end())
            out.push_back(&*far);
    }
    return out;
}

} // namespace

bool can_rest(std::span<const Gap> contacts, double reach) {
    if (contacts.empty())
        return false;
    std::vector<Wrench> edges;
    for (const Gap* contact : outermost(contacts))
        add_cone(*contact, reach, edges);
    std::vector<double> forces(edges.size(), 0.0);
    Wrench missing{0, 1, 0, 0, 0, 0};
    double last = 1; // what was missing at the last look, squared
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
        for (std::size_t k = 0; k < edges.size(); ++k) {
            const double next =
                std::max(0.0, forces[k] + dot(edges[k], missing) / dot(edges[k], edges[k]));
            for (std::size_t i = 0; i < missing.size(); ++i)
                missing[i] -= (next - forces[k]) * edges[k][i];
            forces[k] = next;
        }
        const double left = dot(missing, missing);
        if (left < enough * enough)
            return true;
        if (sweep % sweeps_between_looks > 0)
            continue;
        if (left > least_progress * last)
            return false; // as near as the cones come, or so
        last = left;
    }
    return false;
}

} // namespace scree::rocks
