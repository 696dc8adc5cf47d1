// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh/largest_ball.h"

#include "geometry/mesh/triangle_distance.h"

#include <algorithm>
#include <limits>

namespace scree {

namespace {

// Distance to the nearest triangle; if some triangle is nearer than `enough`, the distance to the
// first such one, which is then moved to the front, as it is likely to be near again.
float distance_to(std::vector<DistanceTriangle>& triangles, const Vec3& p, float enough) {
    float least = std::numeric_limits<float>::max();
    for (DistanceTriangle& triangle : triangles) {
        least = std::min(least, triangle.distance2(p));
        if (least < enough * enough) {
            std::swap(triangle, triangles.front());
            break;
        }
    }
    return std::sqrt(least);
}

// Directions spread evenly over the sphere (a Fibonacci lattice), turned a little more every round,
// so that in some round one of them runs along a ridge of the distance.
Vec3 direction(int i, int count, int round) {
    const double y = 1 - (2 * i + 1.0) / count;
    const double turn = i * pi * (3 - std::sqrt(5.0)) + 0.7 * round;
    const double r = std::sqrt(1 - y * y);
    return {static_cast<float>(r * std::cos(turn)), static_cast<float>(y),
            static_cast<float>(r * std::sin(turn))};
}

// By the solid angle of the triangles seen from p (van Oosterom & Strackee 1983).
bool encloses(const Mesh& mesh, const Imath::V3d& p) {
    double angle = 0;
    for (const Mesh::Triangle& t : mesh.triangles) {
        const Imath::V3d a = Imath::V3d(mesh.positions[t[0]]) - p;
        const Imath::V3d b = Imath::V3d(mesh.positions[t[1]]) - p;
        const Imath::V3d c = Imath::V3d(mesh.positions[t[2]]) - p;
        const double la = a.length();
        const double lb = b.length();
        const double lc = c.length();
        angle += 2 * std::atan2(a.dot(b.cross(c)),
                                la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
    }
    return std::abs(angle) > 2 * pi;
}

} // namespace

Ball largest_inside(const Mesh& mesh, std::vector<Ball> balls) {
    std::sort(balls.begin(), balls.end(),
              [](const Ball& a, const Ball& b) { return a.radius > b.radius; });
    for (const Ball& ball : balls)
        if (encloses(mesh, Imath::V3d(ball.centre)))
            return ball;
    return {};
}

Ball climb_to_largest(const Mesh& mesh, const Ball& start) {
    // The centre moves by at most the start's radius, and the ball's radius grows to at most twice
    // that: triangles farther away do not matter.
    constexpr float farthest = 4;
    std::vector<DistanceTriangle> near;
    for (const Mesh::Triangle& t : mesh.triangles) {
        const DistanceTriangle triangle(
            {mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]});
        if (triangle.distance2(start.centre) < farthest * start.radius * farthest * start.radius)
            near.push_back(triangle);
    }
    Ball best{start.centre, distance_to(near, start.centre, 0)};
    constexpr int directions = 24;
    float step = 0.2F * start.radius;
    for (int round = 0; step > 1e-4F * start.radius && round < 400; ++round) {
        bool climbed = false;
        for (int i = 0; i < directions && !climbed; ++i) {
            const Vec3 to = best.centre + direction(i, directions, round) * step;
            if ((to - start.centre).length() > start.radius)
                continue;
            const float radius = distance_to(near, to, best.radius);
            if (radius > best.radius * (1 + 1e-6F)) {
                best = {to, radius};
                climbed = true;
            }
        }
        if (!climbed)
            step *= 0.6F;
    }
    return best;
}

} // namespace scree
