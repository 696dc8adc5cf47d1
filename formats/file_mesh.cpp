// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/file_mesh.h"

#include "geometry/mesh/append_mesh.h"
#include "geometry/mesh/mesh_material.h"
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
    out.parts = mesh.parts;
    out.materials = mesh.materials;
    return out;
}

// Drops optional values that one of both lacks.
template <class T>
void drop_unless_both(FileMesh& mesh, std::vector<T>& values, std::vector<T>& more,
                      const std::string& what) {
    if (mesh.positions.empty() || values.empty() == more.empty())
        return;
    const std::string warning = "its " + what + " are not read, since parts of it lack them";
    if (std::ranges::find(mesh.warnings, warning) == mesh.warnings.end())
        mesh.warnings.push_back(warning);
    values.clear();
    more.clear();
}

} // namespace

void append(FileMesh& mesh, FileMesh part) {
    if (part.positions.empty())
        return;
    drop_unless_both(mesh, mesh.normals, part.normals, "normals");
    drop_unless_both(mesh, mesh.uvs, part.uvs, "texture coordinates");
    append_mesh(mesh, part);
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

Mesh to_mesh(const FileMesh& mesh) {
    Mesh out = converted<Mesh>(mesh);
    if (out.materials == nullptr)
        out.materials = std::make_shared<const MeshMaterials>();
    return out;
}

FileMesh to_file_mesh(const Mesh& mesh) { return converted<FileMesh>(mesh); }

} // namespace scree
