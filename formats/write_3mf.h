// SPDX-License-Identifier: GPL-3.0-or-later
// 3MF files: the only place that uses lib3mf.
#pragma once

#include "geometry/mesh/mesh.h"

namespace scree {

/// Writes a closed mesh as the only object of a 3MF file (3MF Core Specification), in millimetres
/// with z up, with a `title` that programs show. Equal meshes give equal bytes. Throws Error
/// (resource) on an unwritable path, a full disk, or more triangles than lib3mf supports.
void write_3mf(const std::string& path, const Mesh& mesh, const std::string& title);

} // namespace scree
