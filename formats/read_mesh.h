// SPDX-License-Identifier: GPL-3.0-or-later
// Mesh files, one reader per format. The readers take the file's bytes, which may be malicious.
#pragma once

#include "formats/file_mesh.h"

#include <string>
#include <string_view>

namespace scree {

/// Reads an OBJ, PLY, STL, glTF (.gltf, .glb) or 3DS file, chosen by its extension. Positions are
/// finite, indices in range and there is at least one triangle; normals and UVs are kept if the
/// file has them for every vertex. Throws Error (input) that begins with the path.
FileMesh read_file_mesh(const std::string& path);

/// The same for given bytes, as if they were the content of `path`.
FileMesh read_file_mesh_bytes(const std::string& path, std::string_view bytes);

/// The same in single precision, named after the file; without what the reader warned of.
Mesh read_mesh(const std::string& path);
Mesh read_mesh_bytes(const std::string& path, std::string_view bytes);

/// The readers of the formats. They throw Error (input) without the file's name.
FileMesh read_ply(std::string_view bytes);
FileMesh read_stl(std::string_view bytes);
FileMesh read_3ds(std::string_view bytes);
/// `folder` holds the files that the file names: materials, buffers, pictures.
FileMesh read_obj(std::string_view bytes, const std::string& folder);
FileMesh read_gltf(std::string_view bytes, const std::string& folder);

} // namespace scree
