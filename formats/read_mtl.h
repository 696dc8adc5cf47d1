// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/mesh/mesh_material.h"

#include <string>
#include <vector>

namespace scree {

/// The materials of the given names, in that order, from the MTL libraries (Wavefront, "MTL
/// material format") that an OBJ file in `folder` names: the texts behind its words `mtllib`, which
/// are one file name or several. An empty name stands for faces without a material. What no library
/// has looks grey, and is noted. The `problem` of the result is set when no library can be read.
MeshMaterials read_mtl(const std::vector<std::string>& libraries,
                       const std::vector<std::string>& names, const std::string& folder);

} // namespace scree
