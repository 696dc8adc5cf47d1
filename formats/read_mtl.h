// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/mesh/mesh_material.h"

#include <string>
#include <vector>

namespace scree {

/// A material that an OBJ file uses.
struct MaterialUse {
    std::string name;     // "" for faces without a material
    std::size_t line = 0; // of the first `usemtl` that faces follow
};

/// The materials that are used, in that order, from the MTL libraries (Wavefront, "MTL material
/// format") that an OBJ file in `folder` names: the texts behind its words `mtllib`, which are one
/// file name or several. What no library has looks grey, and is noted. The `problem` of the result
/// is set when no library can be read.
MeshMaterials read_mtl(const std::vector<std::string>& libraries,
                       const std::vector<MaterialUse>& uses, const std::string& folder);

} // namespace scree
