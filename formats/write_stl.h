// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/mesh/mesh.h"

namespace scree {

/// A mesh as a binary STL (3D Systems 1989), in millimetres with z up, as printers take it, for the
/// file itself has no units. Throws Error: resource on an unwritable path, a full disk, or more
/// than 2^32 triangles, which the format cannot count.
void write_stl(const std::string& path, const Mesh& mesh);

} // namespace scree
