// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh/side_normals.h"

#include "geometry/mesh/triangle_corners.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <unordered_map>

namespace scree {

namespace {

// Lengths over the longest edge.
constexpr float on_edge = 1e-4F; // distance of a place that is on an edge or a corner
constexpr float thin = 1e-4F;    // height of a facet that is too thin for a normal

std::uint64_t edge_key(std::uint32_t a, std::uint32_t b) {
    return (std::uint64_t(std::min(a, b)) << 32) | std::max(a, b);
}

float longest_edge2(const std::array<Vec3, 3>& p) {
    return std::max({(p[1] - p[0]).length2(), (p[2] - p[1]).length2(), (p[0] - p[2]).length2()});
}

float distance_to_edge(const Vec3& p, const Vec3& a, const Vec3& b) {
    const Vec3 d = b - a;
    const float share = d.length2() > 0 ? std::clamp((p - a).dot(d) / d.length2(), 0.0F, 1.0F) : 0;
    return (p - a - d * share).length();
}

float angle_between(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).length(), a.dot(b));
}

} // namespace

double winding_number(const Mesh& mesh, const Imath::V3d& p) {
    double sum = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        std::array<Imath::V3d, 3> to;
        std::array<double, 3> length{};
        const auto corners = corners_of(mesh, t);
        for (std::size_t c = 0; c < 3; ++c) {
            to[c] = Imath::V3d(corners[c]) - p;
            length[c] = to[c].length();
        }
        sum += std::atan2(to[0].dot(to[1].cross(to[2])),
                          length[0] * length[1] * length[2] + to[0].dot(to[1]) * length[2] +
                              to[1].dot(to[2]) * length[0] + to[2].dot(to[0]) * length[1]);
    }
    return sum / (2 * std::numbers::pi);
}

SideNormals::SideNormals(const Mesh& mesh) : mesh_(&mesh), normals_(mesh.triangles.size()) {
    const std::vector<std::uint32_t> welded = weld(mesh);
    std::vector<Vec3> around(mesh.positions.size(), Vec3(0.0F));
    std::unordered_map<std::uint64_t, Vec3> edges;
    for (std::size_t t = 0; t < normals_.size(); ++t) {
        const Mesh::Triangle& corners = mesh.triangles[t];
        const auto p = corners_of(mesh, t);
        const float longest2 = longest_edge2(p);
        Vec3 facet = (p[1] - p[0]).cross(p[2] - p[0]);
        facet = facet.length() > thin * longest2 ? facet.normalized() : Vec3(0.0F);
        normals_[t].facet = facet;
        for (std::size_t c = 0; c < 3; ++c) {
            const std::size_t next = (c + 1) % 3;
            const std::size_t last = (c + 2) % 3;
            around[welded[corners[c]]] += facet * angle_between(p[next] - p[c], p[last] - p[c]);
            edges.try_emplace(edge_key(welded[corners[next]], welded[corners[last]]), Vec3(0.0F))
                .first->second += facet;
        }
    }
    for (std::size_t t = 0; t < normals_.size(); ++t)
        for (std::size_t c = 0; c < 3; ++c) {
            const Mesh::Triangle& corners = mesh.triangles[t];
            normals_[t].corners[c] = around[welded[corners[c]]];
            normals_[t].opposite[c] =
                edges.at(edge_key(welded[corners[(c + 1) % 3]], welded[corners[(c + 2) % 3]]));
        }
}

Vec3 SideNormals::at(std::uint32_t triangle, const Vec3& place) const {
    const Normals& normals = normals_[triangle];
    const auto p = corners_of(*mesh_, triangle);
    const float most = on_edge * std::sqrt(longest_edge2(p));
    std::size_t nearest = 0;
    float least = std::numeric_limits<float>::infinity();
    for (std::size_t c = 0; c < 3; ++c) {
        if ((place - p[c]).length() <= most)
            return normals.corners[c];
        const float distance = distance_to_edge(place, p[(c + 1) % 3], p[(c + 2) % 3]);
        if (distance < least) {
            least = distance;
            nearest = c;
        }
    }
    const bool has_facet = normals.facet.length2() > 0;
    return least <= most || !has_facet ? normals.opposite[nearest] : normals.facet;
}

} // namespace scree
