// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/registry.h"

namespace scree {

/// mesh.file: a mesh read from OBJ, PLY, STL or glTF by its ending. Errors (missing file, damaged
/// file, open mesh where a closed one is asked for, NaN positions) name the script's line.
Registry<Mesh(const Params& params)> mesh_file_table();

} // namespace scree
