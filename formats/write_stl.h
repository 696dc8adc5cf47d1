// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/mesh/mesh.h"

namespace scree {

/// Writes a mesh as a binary STL (3D Systems 1989). STL has no units: it is in millimetres with z
/// up, the convention of printers. Throws Error (resource) on an unwritable path, a full disk, or
/// more than 2^32 triangles, which the format cannot count.
void write_stl(const std::string& path, const Mesh& mesh);

} // namespace scree
