// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh/mesh.h"

#include "geometry/mesh/append_mesh.h"

#include <algorithm>
#include <bit>
#include <map>
#include <numeric>
#include <unordered_map>

namespace scree {

namespace {

Vec3 face_vector(const Mesh& mesh, const Mesh::Triangle& t) {
    const Vec3& a = mesh.positions[t[0]];
    return (mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a);
}

float corner_angle(const Vec3& at, const Vec3& left, const Vec3& right) {
    const Vec3 u = left - at;
    const Vec3 v = right - at;
    return std::atan2(u.cross(v).length(), u.dot(v));
}

struct PositionHash {
    std::size_t operator()(const Vec3& p) const {
        std::uint64_t hash = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const float value = p[axis] == 0.0F ? 0.0F : p[axis]; // -0 equals 0
            hash = (hash ^ std::bit_cast<std::uint32_t>(value)) * 0x9e3779b97f4a7c15ULL;
            hash ^= hash >> 32;
        }
        return hash;
    }
};

} // namespace

Box3 bounds(const Mesh& mesh) {
    Box3 box;
    for (const Vec3& p : mesh.positions)
        box.extendBy(p);
    return box;
}

double area(const Mesh& mesh) {
    double twice = 0;
    for (const Mesh::Triangle& t : mesh.triangles)
        twice += double(face_vector(mesh, t).length());
    return twice / 2;
}

double volume(const Mesh& mesh) {
    double six_times = 0;
    for (const Mesh::Triangle& t : mesh.triangles) {
        const Imath::V3d a(mesh.positions[t[0]]);
        const Imath::V3d b(mesh.positions[t[1]]);
        const Imath::V3d c(mesh.positions[t[2]]);
        six_times += a.dot(b.cross(c));
    }
    return six_times / 6;
}

std::vector<std::uint32_t> weld(const Mesh& mesh) {
    std::unordered_map<Vec3, std::uint32_t, PositionHash> first;
    first.reserve(mesh.positions.size());
    std::vector<std::uint32_t> welded(mesh.positions.size());
    for (std::uint32_t i = 0; i < welded.size(); ++i)
        welded[i] = first.try_emplace(mesh.positions[i], i).first->second;
    return welded;
}

MeshFacts inspect(const Mesh& mesh) {
    MeshFacts facts;
    facts.finite = std::all_of(mesh.positions.begin(), mesh.positions.end(), is_finite);
    const std::vector<std::uint32_t> welded = weld(mesh);
    struct Use {
        int forward = 0;
        int backward = 0;
    };
    std::map<std::pair<std::uint32_t, std::uint32_t>, Use> edges;
    for (const Mesh::Triangle& t : mesh.triangles) {
        const std::array<std::uint32_t, 3> v{welded[t[0]], welded[t[1]], welded[t[2]]};
        if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0]) {
            ++facts.degenerate_triangles;
            continue; // a sliver that welding closed: its neighbours meet each other
        }
        for (int k = 0; k < 3; ++k) {
            const std::uint32_t a = v[k];
            const std::uint32_t b = v[(k + 1) % 3];
            Use& use = edges[std::minmax(a, b)];
            ++(a < b ? use.forward : use.backward);
        }
    }
    for (const auto& [edge, use] : edges) {
        if (use.forward + use.backward == 1)
            ++facts.boundary_edges;
        else if (use.forward != 1 || use.backward != 1)
            ++facts.non_manifold_edges;
    }
    return facts;
}

void compute_normals(Mesh& mesh, double crease, NormalWeight weight) {
    const std::vector<std::uint32_t> welded = weld(mesh);
    const float limit = static_cast<float>(std::cos(crease));
    struct Corner {
        std::uint32_t triangle;
        int slot;
        float weight;
    };
    std::vector<std::vector<Corner>> corners(mesh.positions.size());
    std::vector<Vec3> faces(mesh.triangles.size());
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const Mesh::Triangle& t = mesh.triangles[i];
        const Vec3 vector = face_vector(mesh, t);
        faces[i] = vector.normalized();
        const float share = weight == NormalWeight::angle ? 1.0F : vector.length();
        for (int k = 0; k < 3; ++k) {
            const float angle = corner_angle(mesh.positions[t[k]], mesh.positions[t[(k + 1) % 3]],
                                             mesh.positions[t[(k + 2) % 3]]);
            corners[welded[t[k]]].push_back({i, k, angle * share});
        }
    }

    Mesh out;
    out.name = mesh.name;
    out.triangles = mesh.triangles;
    out.parts = mesh.parts;
    out.materials = mesh.materials;
    out.unit_unknown = mesh.unit_unknown;
    // A corner's normal sums the faces round its vertex that turn away less than the crease;
    // corners of one vertex with equal normals stay one vertex.
    std::map<std::uint32_t, std::vector<std::uint32_t>> made; // old vertex -> new vertices
    for (const std::vector<Corner>& around : corners) {
        // Every pair of faces is looked at: a vertex of a forged file must not take hours.
        const bool crowded = around.size() > 4096;
        for (const Corner& corner : around) {
            Vec3 normal(0.0F);
            if (crowded)
                normal = faces[corner.triangle];
            else
                for (const Corner& other : around)
                    if (faces[corner.triangle].dot(faces[other.triangle]) >= limit)
                        normal += faces[other.triangle] * other.weight;
            normal.normalize();
            if (!(normal.length2() > 0.5F))
                normal = Vec3(0, 1, 0); // of faces without area: any unit vector
            const std::uint32_t old = mesh.triangles[corner.triangle][corner.slot];
            std::vector<std::uint32_t>& candidates = made[old];
            const auto same =
                std::find_if(crowded ? candidates.end() : candidates.begin(), candidates.end(),
                             [&](std::uint32_t candidate) {
                                 return out.normals[candidate].equalWithAbsError(normal, 1e-5F);
                             });
            std::uint32_t vertex = 0;
            if (same != candidates.end()) {
                vertex = *same;
            } else {
                vertex = static_cast<std::uint32_t>(out.positions.size());
                out.positions.push_back(mesh.positions[old]);
                out.normals.push_back(normal);
                if (!mesh.uvs.empty())
                    out.uvs.push_back(mesh.uvs[old]);
                candidates.push_back(vertex);
            }
            out.triangles[corner.triangle][corner.slot] = vertex;
        }
    }
    mesh = std::move(out);
}

Vec3 smooth_normal(const Mesh& mesh, std::uint32_t triangle, const Imath::V3d& position,
                   const Vec3& facet) {
    if (mesh.normals.empty())
        return facet;
    const Mesh::Triangle& t = mesh.triangles[triangle];
    const Imath::V3d a(mesh.positions[t[0]]);
    const Imath::V3d ab = Imath::V3d(mesh.positions[t[1]]) - a;
    const Imath::V3d ac = Imath::V3d(mesh.positions[t[2]]) - a;
    const Imath::V3d to = position - a;
    const Imath::V3d n = ab.cross(ac);
    const auto v = static_cast<float>(to.cross(ac).dot(n) / n.length2());
    const auto w = static_cast<float>(ab.cross(to).dot(n) / n.length2());
    const Vec3 smooth =
        mesh.normals[t[0]] * (1 - v - w) + mesh.normals[t[1]] * v + mesh.normals[t[2]] * w;
    return smooth.length() > 0 ? smooth.normalized() : facet;
}

void normalise_size(Mesh& mesh, double size) {
    const Box3 box = bounds(mesh);
    const Vec3 extent = box.size();
    const float longest = std::max({extent.x, extent.y, extent.z});
    if (!(longest > 0))
        return; // a point has no size to change
    const Vec3 foot(box.center().x, box.min.y, box.center().z);
    const float factor = static_cast<float>(size) / longest;
    for (Vec3& p : mesh.positions)
        p = (p - foot) * factor;
}

void append(Mesh& mesh, const Mesh& other) { append_mesh(mesh, other); }

void transform(Mesh& mesh, const Matrix& matrix) {
    for (Vec3& p : mesh.positions)
        p = transform_point(matrix, p);
    if (!mesh.normals.empty()) {
        const Matrix normal_matrix = matrix.inverse().transposed();
        for (Vec3& n : mesh.normals)
            n = transform_direction(normal_matrix, n).normalized();
    }
    if (matrix.determinant() < 0)
        for (Mesh::Triangle& t : mesh.triangles)
            std::swap(t[1], t[2]);
}

} // namespace scree
