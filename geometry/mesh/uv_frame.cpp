// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh/uv_frame.h"

#include "geometry/mesh/uv_jacobian.h"

#include <algorithm>
#include <cassert>

namespace scree {

namespace {

// v without its part along the unit vector n.
Vec3 flattened(const Vec3& v, const Vec3& n) { return v - n * n.dot(v); }

Vec3 any_at_right_angles(const Vec3& n) {
    return flattened(std::abs(n.x) < 0.6F ? Vec3(1, 0, 0) : Vec3(0, 1, 0), n).normalized();
}

float angle_between(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).length(), a.dot(b));
}

} // namespace

Vec3 UvFrames::vertex_normal(std::uint32_t triangle, std::size_t corner) const {
    const Mesh::Triangle& t = mesh_.triangles[triangle];
    return mesh_.normals.empty() ? Vec3(UvJacobian(mesh_, t).cross.normalized())
                                 : mesh_.normals[t[corner]];
}

UvFrames::UvFrames(const Mesh& mesh)
    : mesh_(mesh), tangents_(mesh.positions.size(), {Vec3(0.0F), Vec3(0.0F)}) {
    assert(mesh.uvs.size() == mesh.positions.size());
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const Mesh::Triangle& t = mesh.triangles[i];
        const UvJacobian face(mesh, t);
        if (face.turn == 0)
            continue;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 normal = vertex_normal(i, k);
            const Vec3& here = mesh.positions[t[k]];
            const Vec3 left = flattened(mesh.positions[t[(k + 1) % 3]] - here, normal);
            const Vec3 right = flattened(mesh.positions[t[(k + 2) % 3]] - here, normal);
            tangents_[t[k]][face.turn > 0 ? 0 : 1] +=
                flattened(Vec3(face.along_u.normalized()), normal).normalized() *
                angle_between(left, right);
        }
    }
    for (auto& sides : tangents_)
        for (Vec3& tangent : sides)
            tangent.normalize(); // zero stays zero
}

UvAxes UvFrames::at(std::uint32_t triangle, const Vec3& barycentric) const {
    const Mesh::Triangle& t = mesh_.triangles[triangle];
    const UvJacobian face(mesh_, t);
    const std::size_t side = face.turn >= 0 ? 0 : 1;
    Vec3 normal(0.0F);
    Vec3 tangent(0.0F);
    for (std::size_t k = 0; k < 3; ++k) {
        normal += vertex_normal(triangle, k) * barycentric[int(k)];
        tangent += tangents_[t[k]][side] * barycentric[int(k)];
    }
    UvAxes out;
    out.normal = normal.normalized();
    out.tangent = flattened(tangent, out.normal).normalized();
    if (!(out.tangent.length2() > 0.5F))
        out.tangent = any_at_right_angles(out.normal);
    // The UVs of a mirrored face turn the other way; so does v.
    out.bitangent = out.normal.cross(out.tangent) * (side == 0 ? 1.0F : -1.0F);
    return out;
}

UvScale uv_scale(const Mesh& mesh) {
    double area = 0;
    Vec2 sum(0.0);
    Vec2 sum_of_squares(0.0);
    for (const Mesh::Triangle& t : mesh.triangles) {
        const UvJacobian face(mesh, t);
        if (face.turn == 0)
            continue;
        const double weight = face.cross.length();
        const Vec2 length(face.along_u.length(), face.along_v.length());
        area += weight;
        sum += length * weight;
        sum_of_squares += length * length * weight;
    }
    UvScale out;
    if (!(area > 0))
        return out;
    out.size = sum / area;
    for (const auto& [mean, square] : {std::pair(out.size.x, sum_of_squares.x / area),
                                       std::pair(out.size.y, sum_of_squares.y / area)})
        if (mean > 0)
            out.spread =
                std::max(out.spread, std::sqrt(std::max(0.0, square - mean * mean)) / mean);
    return out;
}

} // namespace scree
