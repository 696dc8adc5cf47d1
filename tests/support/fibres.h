// SPDX-License-Identifier: GPL-3.0-or-later
// Fibres for tests, and measures of them in double that share nothing with the generator.
#pragma once

#include "core/parallel.h"
#include "generators/table.h"
#include "tests/support/aggregates.h"
#include "tests/support/component_checks.h"
#include "tests/support/plugin_params.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <map>
#include <numeric>
#include <set>

namespace scree::tests {

using FibreValues = std::map<std::string, Value>;

inline SharedObject shared_component(const std::string& name,
                                     const std::map<std::string, Value>& values) {
    return SharedObject(std::make_shared<const Mesh>(component_mesh(name, values)));
}

inline SharedObject ball_target(double radius) {
    return shared_component("sphere", {{"radius", radius}});
}

inline Aggregate bake_fibres(const FibreValues& values, const Context& context = {}) {
    return make(generator_table(), "fibres", values)(context);
}

inline std::shared_ptr<const Strands> strands_of(const Aggregate& aggregate) {
    return std::get<std::shared_ptr<const Strands>>(aggregate.prototypes.at(0).shape);
}

/// Bakes on each number of threads; the first at which points have other bytes than without a
/// limit, 0 if there is none.
inline int threads_that_differ(const FibreValues& values, std::initializer_list<int> threads) {
    const auto first = strands_of(bake_fibres(values));
    for (const int number : threads) {
        const ThreadLimit limit(number);
        const auto again = strands_of(bake_fibres(values));
        if (std::memcmp(first->points.data(), again->points.data(),
                        first->points.size() * sizeof(Vec3)) != 0)
            return number;
    }
    return 0;
}

/// The vertices of one strand.
inline std::span<const Vec3> strand(const Strands& strands, std::size_t i) {
    return std::span(strands.points)
        .subspan(strands.offsets[i], strands.offsets[i + 1] - strands.offsets[i]);
}

inline WideVec3 centroid(std::span<const Vec3> points) {
    WideVec3 sum(0.0);
    for (const Vec3& p : points)
        sum += WideVec3(p);
    return sum / double(points.size());
}

/// Angle between the segments before and after vertex i [rad].
inline double joint_angle(std::span<const Vec3> points, std::size_t i) {
    const WideVec3 a = WideVec3(points[i]) - WideVec3(points[i - 1]);
    const WideVec3 b = WideVec3(points[i + 1]) - WideVec3(points[i]);
    return std::atan2(a.cross(b).length(), a.dot(b));
}

/// The largest error of a segment's length over its fibre's mean.
inline double stretch(const Strands& strands) {
    double worst = 0;
    for (std::size_t f = 0; f < strands.count(); ++f) {
        const auto points = strand(strands, f);
        double sum = 0;
        for (std::size_t i = 1; i < points.size(); ++i)
            sum += (WideVec3(points[i]) - WideVec3(points[i - 1])).length();
        const double mean = sum / double(points.size() - 1);
        for (std::size_t i = 1; i < points.size(); ++i)
            worst = std::max(
                worst,
                std::abs((WideVec3(points[i]) - WideVec3(points[i - 1])).length() / mean - 1));
    }
    return worst;
}

inline double point_segment_distance(const WideVec3& p, const WideVec3& a, const WideVec3& b) {
    const double t = std::clamp((p - a).dot(b - a) / (b - a).length2(), 0.0, 1.0);
    return (p - a - (b - a) * t).length();
}

/// Distance between two segments: of an end of one from the other, or, where the common
/// perpendicular of their lines meets both, its length.
inline double segment_distance(const std::array<WideVec3, 2>& a, const std::array<WideVec3, 2>& b) {
    double least = std::min(
        {point_segment_distance(a[0], b[0], b[1]), point_segment_distance(a[1], b[0], b[1]),
         point_segment_distance(b[0], a[0], a[1]), point_segment_distance(b[1], a[0], a[1])});
    const WideVec3 d = a[1] - a[0];
    const WideVec3 e = b[1] - b[0];
    const WideVec3 across = d.cross(e);
    const double n2 = across.length2();
    if (n2 < 1e-18 * d.length2() * e.length2())
        return least;
    const WideVec3 between = b[0] - a[0];
    const double s = between.cross(e).dot(across) / n2;
    const double t = between.cross(d).dot(across) / n2;
    if (s >= 0 && s <= 1 && t >= 0 && t <= 1)
        least = std::min(least, std::abs(between.dot(across)) / std::sqrt(n2));
    return least;
}

/// A segment of a fibre, and the box about it.
struct FibreSegment {
    std::array<WideVec3, 2> ends;
    std::size_t fibre, index;
    WideVec3 low, high;
};

/// Calls found(segment, segment, distance) for all pairs whose axes are nearer than `near` [m].
template <class Found>
void each_near_pair(const Strands& strands, double near, const Found& found) {
    std::vector<FibreSegment> all;
    for (std::size_t f = 0; f < strands.count(); ++f) {
        const auto points = strand(strands, f);
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            FibreSegment s{{WideVec3(points[i]), WideVec3(points[i + 1])}, f, i, {}, {}};
            for (int axis = 0; axis < 3; ++axis) {
                s.low[axis] = std::min(s.ends[0][axis], s.ends[1][axis]) - near / 2;
                s.high[axis] = std::max(s.ends[0][axis], s.ends[1][axis]) + near / 2;
            }
            all.push_back(s);
        }
    }
    std::ranges::sort(all, {}, [](const FibreSegment& s) { return s.low.x; });
    for (std::size_t a = 0; a < all.size(); ++a)
        for (std::size_t b = a + 1; b < all.size() && all[b].low.x <= all[a].high.x; ++b) {
            const FibreSegment& s = all[a];
            const FibreSegment& t = all[b];
            if (s.low.y > t.high.y || t.low.y > s.high.y || s.low.z > t.high.z ||
                t.low.z > s.high.z)
                continue;
            if (const double distance = segment_distance(s.ends, t.ends); distance < near)
                found(s, t, distance);
        }
}

/// How deep segments are in each other, of all pairs whose axes are nearer than 1.02 diameters, in
/// radii; all fibres are of the radius [m]. Segments of one fibre less than four radii apart along
/// it are none.
inline std::vector<double> contact_depths(const Strands& strands, double radius) {
    std::vector<double> depths;
    each_near_pair(strands, 2.04 * radius,
                   [&](const FibreSegment& s, const FibreSegment& t, double distance) {
                       const double length = (s.ends[1] - s.ends[0]).length();
                       const double between = std::abs(double(s.index) - double(t.index)) - 1;
                       if (s.fibre == t.fibre && (between < 1 || between * length < 4 * radius))
                           return;
                       depths.push_back(std::max(0.0, 2 - distance / radius));
                   });
    return depths;
}

/// The pairs of different fibres whose axes are nearer than `near` [m].
inline std::set<std::array<std::size_t, 2>> touching_fibres(const Strands& strands, double near) {
    std::set<std::array<std::size_t, 2>> pairs;
    each_near_pair(strands, near, [&](const FibreSegment& s, const FibreSegment& t, double) {
        if (s.fibre != t.fibre)
            pairs.insert({std::min(s.fibre, t.fibre), std::max(s.fibre, t.fibre)});
    });
    return pairs;
}

} // namespace scree::tests
