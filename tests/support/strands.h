// SPDX-License-Identifier: GPL-3.0-or-later
// Strands for tests, and their distances by brute force.
#pragma once

#include "geometry/mesh/strands.h"
#include "tests/support/rendering.h"

namespace scree::test {

/// A strand more of the same kind.
inline void add_strand(Strands& strands, const std::vector<Vec3>& points,
                       const std::vector<float>& radii) {
    if (strands.offsets.empty())
        strands.offsets.push_back(0);
    strands.points.insert(strands.points.end(), points.begin(), points.end());
    strands.radii.insert(strands.radii.end(), radii.begin(), radii.end());
    strands.offsets.push_back(static_cast<std::uint32_t>(strands.points.size()));
}

/// Chains of steps of one length that turn by up to `bend` [rad] at each joint.
inline Strands random_chains(Random& random, std::size_t count, int segments, float step,
                             float radius, float bend, CurveKind kind = CurveKind::linear) {
    Strands strands;
    strands.name = "chains";
    strands.kind = kind;
    for (std::size_t i = 0; i < count; ++i) {
        std::vector<Vec3> points{random_direction(random) * random.uniform_float()};
        Vec3 direction = random_direction(random);
        for (int k = 0; k < segments; ++k) {
            points.push_back(points.back() + direction * step);
            Matrix turn;
            turn.setAxisAngle(random_direction(random), bend * random.uniform_float());
            direction = transform_direction(turn, direction).normalized();
        }
        add_strand(strands, points, std::vector<float>(points.size(), radius));
    }
    return strands;
}

inline Ray towards(const Vec3& from, const Vec3& target) {
    return {from, (target - from).normalized()};
}

/// Splines as Embree's own, not as cones.
inline constexpr WorldLimits no_chords{.most_chords = 0};

/// A world of strands alone.
inline World strand_world(const Strands& strands, const Material& material,
                          const std::vector<WideMatrix>& places = {WideMatrix()},
                          const std::vector<float>& randoms = {}, const WorldLimits& limits = {}) {
    Aggregate aggregate;
    aggregate.generator = "object";
    aggregate.prototypes.push_back({.name = "strands",
                                    .shape = std::make_shared<const Strands>(strands),
                                    .materials = {std::make_shared<const Material>(material)}});
    for (std::size_t i = 0; i < places.size(); ++i)
        aggregate.instances.push_back({.prototype = 0,
                                       .world_from_object = places[i],
                                       .random = randoms.empty() ? 0 : randoms[i]});
    return World({&aggregate, 1}, {}, {}, WideVec3(0), limits);
}

/// A point of a piece of a uniform cubic B-spline, by de Boor's recurrence.
inline Vec3 spline_point(const Vec3* c, float u) {
    const auto mix = [](const Vec3& a, const Vec3& b, float t) { return a * (1 - t) + b * t; };
    const Vec3 a = mix(c[0], c[1], (u + 2) / 3);
    const Vec3 b = mix(c[1], c[2], (u + 1) / 3);
    const Vec3 d = mix(c[2], c[3], u / 3);
    return mix(mix(a, b, (u + 1) / 2), mix(b, d, u / 2), u);
}

} // namespace scree::test
