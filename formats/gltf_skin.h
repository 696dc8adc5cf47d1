// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/gltf_data.h"
#include "formats/gltf_nodes.h"

namespace scree::gltf {

/// Where the joints of a skin, in the pose of the file's nodes, put each of a primitive's
/// `vertices`: the place of the node that bears the mesh does not count (glTF 2.0, section 3.7.3).
/// Throws Error (input) for joints or weights that are missing, damaged or all 0.
std::vector<Imath::M44d> skin_matrices(const File& file, std::size_t skin,
                                       const Primitive& primitive, std::size_t vertices,
                                       const NodePlaces& places, Data& data);

} // namespace scree::gltf
