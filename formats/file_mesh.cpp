// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/file_mesh.h"

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

} // namespace

Mesh to_mesh(const FileMesh& mesh) { return converted<Mesh>(mesh); }

FileMesh to_file_mesh(const Mesh& mesh) { return converted<FileMesh>(mesh); }

} // namespace scree
