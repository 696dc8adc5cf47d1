// SPDX-License-Identifier: GPL-3.0-or-later
// 3MF files: the only door to lib3mf.
#pragma once

#include "geometry/mesh/mesh.h"

namespace scree {

/// A closed mesh as the one object of a 3MF file (3MF Core Specification), in millimetres with z
/// up; `title` is what programs show. The same mesh gives the same bytes. Throws Error (resource)
/// on an unwritable path, a full disk, or more triangles than lib3mf can take.
void write_3mf(const std::string& path, const Mesh& mesh, const std::string& title);

} // namespace scree
