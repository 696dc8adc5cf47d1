// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sampling/surface_points.h"

#include "geometry/sampling/surface_disks.h"

#include <algorithm>
#include <map>
#include <set>

namespace scree {

SurfacePoints surface_points(const Mesh& mesh, double spacing) {
    const SurfaceDiskSet set =
        sample_surface_disks({.mesh = &mesh, .distances = {spacing}, .seed = 0}, {});
    SurfacePoints points;
    points.positions.reserve(set.samples.size());
    points.normals.reserve(set.samples.size());
    for (const SurfaceSample& sample : set.samples) {
        points.positions.emplace_back(sample.position);
        points.normals.push_back(sample.normal);
    }
    return points;
}

double spacing_for(const Mesh& mesh, double count) {
    // Maximal sets have 0.7 disks on the square of their distance.
    return std::sqrt(0.7 * area(mesh) / count);
}

std::vector<Vec3> edge_points(const Mesh& mesh, double spacing) {
    const std::vector<std::uint32_t> welded = weld(mesh);
    struct Faces {
        int count = 0;
        Vec3 first;
        float cosine = -1;
    };
    std::map<std::pair<std::uint32_t, std::uint32_t>, Faces> edges;
    for (const Mesh::Triangle& t : mesh.triangles) {
        const Vec3& a = mesh.positions[t[0]];
        const Vec3 normal = (mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a).normalized();
        for (std::size_t k = 0; k < 3; ++k) {
            Faces& faces = edges[std::minmax(welded[t[k]], welded[t[(k + 1) % 3]])];
            if (++faces.count == 1)
                faces.first = normal;
            else
                faces.cosine = faces.count == 2 ? faces.first.dot(normal) : -1;
        }
    }
    const auto limit = static_cast<float>(std::cos(radians(30)));
    std::vector<Vec3> points;
    std::set<std::uint32_t> ends;
    for (const auto& [edge, faces] : edges) {
        if (edge.first == edge.second || faces.cosine > limit)
            continue;
        ends.insert({edge.first, edge.second});
        const Vec3& a = mesh.positions[edge.first];
        const Vec3 along = mesh.positions[edge.second] - a;
        const int parts = static_cast<int>(std::ceil(double(along.length()) / spacing));
        for (int i = 1; i < parts; ++i)
            points.push_back(a + along * (static_cast<float>(i) / static_cast<float>(parts)));
    }
    for (const std::uint32_t v : ends)
        points.push_back(mesh.positions[v]);
    return points;
}

} // namespace scree
