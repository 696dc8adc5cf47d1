// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/file_mesh.h"

#include "geometry/plane/triangulate_face.h"

#include <algorithm>

namespace scree {

namespace {

// Between meshes that differ in the type of their positions only.
template <class To, class From>
To converted(const From& mesh) {
    To out;
    out.positions.reserve(mesh.positions.size());
    for (const auto& p : mesh.positions)
        out.positions.emplace_back(p);
    out.normals = mesh.normals;
    out.uvs = mesh.uvs;
    out.triangles = mesh.triangles;
    return out;
}

// Appends optional values, which both must have or none has.
template <class T>
void append_optional(FileMesh& mesh, std::vector<T>& values, std::vector<T>& more, bool first,
                     const std::string& what) {
    if (!first && values.empty() != more.empty()) {
        const std::string warning = "its " + what + " are not read, since parts of it lack them";
        if (std::ranges::find(mesh.warnings, warning) == mesh.warnings.end())
            mesh.warnings.push_back(warning);
        values.clear();
        more.clear();
    }
    values.insert(values.end(), more.begin(), more.end());
}

} // namespace

void append(FileMesh& mesh, FileMesh part) {
    if (part.positions.empty())
        return;
    const auto base = static_cast<std::uint32_t>(mesh.positions.size());
    append_optional(mesh, mesh.normals, part.normals, base == 0, "normals");
    append_optional(mesh, mesh.uvs, part.uvs, base == 0, "texture coordinates");
    mesh.positions.insert(mesh.positions.end(), part.positions.begin(), part.positions.end());
    for (const Mesh::Triangle& t : part.triangles)
        mesh.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
    mesh.warnings.insert(mesh.warnings.end(), part.warnings.begin(), part.warnings.end());
}

bool append_face(FileMesh& mesh, std::span<const std::uint32_t> corners) {
    if (corners.size() == 3) {
        mesh.triangles.push_back({corners[0], corners[1], corners[2]});
        return false;
    }
    std::vector<Imath::V3d> points;
    points.reserve(corners.size());
    for (const std::uint32_t corner : corners)
        points.push_back(mesh.positions[corner]);
    const FaceTriangles face = triangulate_face(points);
    for (const auto& t : face.triangles)
        mesh.triangles.push_back({corners[t[0]], corners[t[1]], corners[t[2]]});
    return face.crosses_itself;
}

Mesh to_mesh(const FileMesh& mesh) { return converted<Mesh>(mesh); }

FileMesh to_file_mesh(const Mesh& mesh) { return converted<FileMesh>(mesh); }

} // namespace scree
