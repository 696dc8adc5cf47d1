// SPDX-License-Identifier: GPL-3.0-or-later
// A small valid file of every format that mesh.file reads, with its reader.
#pragma once

#include "geometry/mesh/mesh.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace scree {

struct MeshSeed {
    std::string name; // "ply_big"
    std::string bytes;
    std::function<Mesh(std::string_view)> read;
};

std::vector<MeshSeed> mesh_seeds();

} // namespace scree
