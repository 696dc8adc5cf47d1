// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/scene.h"

#include <string>

namespace scree::bench {

/// Writes a finished scene for drivers of other renderers, such as peers/cycles.py: `scene.json`,
/// the numbers of its meshes, strands and matrices in `scene.bin`, and its textures as EXR files.
/// The folder must exist. Throws Error (usage) on what the drivers cannot match: other materials
/// than matte, plastic, metal and clear glass, skies with an image, and chains of straight strands.
void write_peer_scene(const Scene& scene, const std::string& folder);

} // namespace scree::bench
