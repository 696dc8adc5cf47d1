// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

#include <ImathQuat.h>

#include <vector>

namespace scree::gltf {

struct File;

/// Scales, then turns, then moves. The quaternion is of any length but 0.
Imath::M44d placement(const Imath::V3d& move, const Imath::Quatd& turn, const Imath::V3d& scale);

/// Where the nodes of a file are, and which are to be seen.
struct NodePlaces {
    std::vector<Imath::M44d> world_from_node;
    std::vector<bool> seen; // below a node of the scene, and not hidden
};

/// Of a scene's nodes with all below them, in any depth; without a scene of all nodes. Throws Error
/// (input) for nodes that are children of several, or of themselves.
NodePlaces node_places(const File& file);

} // namespace scree::gltf
