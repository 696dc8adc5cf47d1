// SPDX-License-Identifier: GPL-3.0-or-later
// Mesh files, one reader a format. All are given the file's bytes and must hold against any bytes.
#pragma once

#include "geometry/mesh/mesh.h"

#include <string>
#include <string_view>

namespace scree {

/// Reads an OBJ, PLY, STL, glTF (.gltf, .glb) or 3DS file by its ending. Positions are finite,
/// indices in range and there is at least one triangle; normals and UVs are kept where the file has
/// them for every vertex. Throws Error (input) that begins with the path.
Mesh read_mesh(const std::string& path);

/// The same for bytes at hand, as if `path` held them.
Mesh read_mesh_bytes(const std::string& path, std::string_view bytes);

/// The readers behind it; they throw Error (input) that says what is wrong, without the name.
Mesh read_obj(std::string_view bytes);
Mesh read_ply(std::string_view bytes);
Mesh read_stl(std::string_view bytes);
Mesh read_3ds(std::string_view bytes);
/// `folder` is where a .gltf finds its buffers.
Mesh read_gltf(std::string_view bytes, const std::string& folder);

} // namespace scree
