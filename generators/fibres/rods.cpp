// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators/fibres/rods.h"

#include "core/parallel.h"

#include <algorithm>

namespace scree::fibres {

namespace {

constexpr float length_tolerance = 2e-5F; // of a segment's length

Rotation sum(const Rotation& a, const Rotation& b, float share) {
    return {a.r + share * b.r, a.v + b.v * share};
}

float norm2(const Rotation& q) { return q.r * q.r + q.v.dot(q.v); }

/// Takes two frames towards their rest at the joint between them.
void restore_joint(Rotation& q, Rotation& next, const Rotation& rest, float stiffness) {
    const Rotation now = ~q * next;
    // Of the two rotations that mean the same, the nearer one.
    const float sign = norm2(sum(now, rest, 1)) < norm2(sum(now, rest, -1)) ? -1.0F : 1.0F;
    const Rotation error(0, (now.v - rest.v * sign) * (stiffness / 2));
    const Rotation turn = next * error;
    next = unit(sum(next, q * error, -1));
    q = unit(sum(q, turn, 1));
}

} // namespace

void take_shapes_as_rest(Rods& rods) {
    parallel_for(rods.count(), 64, [&](std::size_t f) {
        const Rod rod = rod_of(rods, f, rods.points);
        follow_segments(rod);
        Rotation* rest = &rods.rest[f * (rods.segments - 1)];
        for (std::uint32_t k = 0; k + 1 < rods.segments; ++k)
            rest[k] = unit(~rod.frames[k] * rod.frames[k + 1]);
    });
}

void follow_segments(const Rod& rod) {
    for (std::size_t i = rod.rooted ? 1 : 0; i < rod.frames.size(); ++i) {
        const Vec3 along = (rod.points[i + 1] - rod.points[i]).normalized();
        rod.frames[i] = unit(from_to(axis_y(rod.frames[i]), along) * rod.frames[i]);
    }
}

void restore_shape(const Rod& rod, float stiffness) {
    const std::size_t joints = rod.rest.size();
    const Rotation root = rod.frames.front();
    for (std::size_t k = 0; k < 2 * joints; ++k) {
        const std::size_t i = k < joints ? k : 2 * joints - 1 - k;
        restore_joint(rod.frames[i], rod.frames[i + 1], rod.rest[i], stiffness);
        if (rod.rooted)
            rod.frames[0] = root;
    }
    const std::size_t segments = rod.frames.size();
    const auto share = [&](std::size_t v) { return rod.rooted && v < 2 ? 0.0F : stiffness / 2; };
    for (std::size_t k = 0; k < 2 * segments; ++k) {
        const std::size_t i = k < segments ? k : 2 * segments - 1 - k;
        const Vec3 error = rod.points[i + 1] - rod.points[i] - axis_y(rod.frames[i]) * rod.length;
        rod.points[i] += error * share(i);
        rod.points[i + 1] -= error * share(i + 1);
    }
}

void restore_lengths(const Rod& rod, LengthWork& work) {
    const std::size_t first = rod.rooted ? 1 : 0;
    const std::size_t n = rod.frames.size() - first;
    if (n == 0)
        return;
    const std::span<Vec3> p = rod.points.subspan(first);
    const float held = rod.rooted ? 0 : 1; // mobility of p[0]
    work.along.resize(n);
    work.excess.resize(n);
    work.upper.resize(n);
    work.move.resize(n);
    for (int step = 0; step < 3; ++step) {
        float worst = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const Vec3 d = p[i + 1] - p[i];
            const float length = d.length();
            work.along[i] = d / length;
            work.excess[i] = length - rod.length;
            worst = std::max(worst, std::abs(work.excess[i]));
        }
        if (worst < length_tolerance * rod.length)
            return;
        // Thomas's algorithm: 2 on the diagonal, minus the cosine between segments beside it.
        const auto beside = [&](std::size_t i) {
            return i + 1 < n ? -work.along[i].dot(work.along[i + 1]) : 0;
        };
        work.upper[0] = beside(0) / (1 + held);
        work.move[0] = work.excess[0] / (1 + held);
        for (std::size_t i = 1; i < n; ++i) {
            const float lower = beside(i - 1);
            const float inverse = 1 / (2 - lower * work.upper[i - 1]);
            work.upper[i] = beside(i) * inverse;
            work.move[i] = (work.excess[i] - lower * work.move[i - 1]) * inverse;
        }
        for (std::size_t i = n - 1; i-- > 0;)
            work.move[i] -= work.upper[i] * work.move[i + 1];
        for (std::size_t i = 0; i < n; ++i) {
            p[i] += work.along[i] * (work.move[i] * (i == 0 ? held : 1));
            p[i + 1] -= work.along[i] * work.move[i];
        }
    }
}

double length_error(const Rods& rods) {
    double worst = 0;
    for (std::size_t f = 0; f < rods.count(); ++f)
        for (std::size_t i = 0; i < rods.segments; ++i) {
            const Vec3* p = &rods.points[f * rods.vertices() + i];
            const double length = (WideVec3(p[1]) - WideVec3(p[0])).length();
            worst = std::max(worst, std::abs(length / double(rods.lengths[f]) - 1));
        }
    return worst;
}

} // namespace scree::fibres
