// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/mesh/mesh.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace scree {

/// The triangles of a file as its reader finds them: a `Mesh` but for positions in double
/// precision, since those of surveyed models lie millions of metres from the origin [units of the
/// file].
struct FileMesh {
    std::vector<Imath::V3d> positions;
    std::vector<Vec3> normals; // none, or one for every position
    std::vector<Vec2f> uvs;    // none, or one for every position
    std::vector<Mesh::Triangle> triangles;
    std::vector<std::uint16_t> parts;               // of each triangle; see Mesh
    std::shared_ptr<const MeshMaterials> materials; // of the parts; null: the file has none
    std::vector<std::string> warnings; // decoration that the file holds and that is not read
};

/// Appends a part of the same file. Texture coordinates and normals are kept only when both have
/// them; a warning tells where not.
void append(FileMesh& mesh, FileMesh part);

/// Appends the triangles of a face whose corners, three or more, are indices of positions in range.
/// Answers whether the face crosses itself.
bool append_face(FileMesh& mesh, std::span<const std::uint32_t> corners);

/// The same in single precision; positions are rounded.
Mesh to_mesh(const FileMesh& mesh);

/// The same in double precision.
FileMesh to_file_mesh(const Mesh& mesh);

} // namespace scree
