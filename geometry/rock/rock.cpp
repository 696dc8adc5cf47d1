// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/rock/rock.h"

#include "geometry/rock/geodesic_sphere.h"

#include <algorithm>

namespace scree {

namespace {

constexpr int measuring_level = 6;
constexpr double least_share = 0.4; // of the body's radius that relief leaves

/// Half the extents of the body's box.
WideVec3 half_extents(const RockBody& body) {
    WideVec3 low(0, 0, 0);
    WideVec3 high(0, 0, 0);
    for (const WideVec3& direction : geodesic_sphere(measuring_level)->directions) {
        const WideVec3 p = direction * body.radius(direction);
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], p[axis]);
            high[axis] = std::max(high[axis], p[axis]);
        }
    }
    return (high - low) * 0.5;
}

WideVec3 axes_of(const RockSettings& settings, const RockBody& body) {
    return WideVec3(1, settings.b_over_a, settings.c_over_a) / half_extents(body);
}

/// Normals of a closed mesh with one vertex in each direction, weighted by the faces' angles there
/// (Thürmer & Wüthrich 1998).
std::vector<Vec3> smooth_normals(const std::vector<WideVec3>& positions,
                                 const std::vector<Mesh::Triangle>& triangles) {
    std::vector<WideVec3> sums(positions.size(), WideVec3(0, 0, 0));
    for (const Mesh::Triangle& t : triangles) {
        const WideVec3 normal =
            (positions[t[1]] - positions[t[0]]).cross(positions[t[2]] - positions[t[0]]);
        const double area = normal.length();
        if (!(area > 0))
            continue;
        for (unsigned k = 0; k < 3; ++k) {
            const WideVec3 a = positions[t[(k + 1) % 3]] - positions[t[k]];
            const WideVec3 b = positions[t[(k + 2) % 3]] - positions[t[k]];
            sums[t[k]] += normal * (std::atan2(area, a ^ b) / area);
        }
    }
    std::vector<Vec3> normals;
    normals.reserve(sums.size());
    for (const WideVec3& sum : sums)
        normals.emplace_back(sum.normalized());
    return normals;
}

} // namespace

Rock::Rock(const RockSettings& settings)
    : random_(settings.seed, Purpose::rock_shape), body_(settings, random_),
      relief_(settings, body_.joints(), random_), axes_(axes_of(settings, body_)) {}

Rock::Rock(const RockSettings& settings, std::vector<RockPlane> cut, const WideVec3& axes)
    : random_(settings.seed, Purpose::rock_shape), body_(settings, random_, std::move(cut)),
      relief_(settings, body_.joints(), random_), axes_(axes) {}

WideVec3 Rock::surface(const WideVec3& direction, double shortest) const {
    const WideVec3 d(direction.x, -direction.z, direction.y); // the body's z is up
    const WideVec3 on_body = d * body_.radius(d) * axes_;
    const double length = on_body.length();
    const double share = 1 + relief_.height(on_body, shortest) / std::max(0.35, length);
    const WideVec3 p = on_body * std::max(least_share, share);
    return {p.x, p.z, -p.y};
}

std::vector<WideVec3> Rock::vertices(int level,
                                     const std::function<double(const WideVec3&)>& limit) const {
    const std::shared_ptr<const GeodesicSphere> sphere = geodesic_sphere(level);
    std::vector<WideVec3> vertices;
    vertices.reserve(sphere->directions.size());
    for (const WideVec3& direction : sphere->directions) {
        WideVec3 p = surface(direction, 2 * sphere->edge);
        if (limit) {
            const double length = p.length();
            p *= std::min(1.0, limit(p / length) / length);
        }
        vertices.push_back(p);
    }
    return vertices;
}

Mesh rock_mesh(const std::vector<WideVec3>& vertices, int level) {
    const std::shared_ptr<const GeodesicSphere> sphere = geodesic_sphere(level);
    const std::vector<Vec3> normals = smooth_normals(vertices, sphere->triangles);
    Mesh mesh;
    mesh.triangles = sphere->corner_triangles;
    mesh.uvs = sphere->uvs;
    for (const std::uint32_t i : sphere->direction_of_corner) {
        mesh.positions.emplace_back(vertices[i]);
        mesh.normals.push_back(normals[i]);
    }
    return mesh;
}

} // namespace scree
