// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene_options.h"
#include "formats/texture_source.h"

namespace scree {

enum class TextureMap { uv, slices, volume };

/// The checked options of `scree texture`.
struct TextureRequest {
    TextureMap map = TextureMap::uv;
    TextureChannel channel = TextureChannel::color;
    std::string ending; // of the file: png, exr, vdb
    int width = 0;      // [pixels]; for a volume, voxels along the longest side
    int height = 0;     // [pixels]; 0: chosen for square pixels
    int slices = 8;
    int axis = 2; // x, y or z
};

/// The options as typed.
struct TextureOptions {
    SceneOptions scene;
    std::string output;
    std::string stats;
    std::string map;
    std::string channel;
    std::string size;
    std::string axis;
    std::string object; // its number or name; empty: the only one
    int slices = 0;     // 0: not given

    void add_to(CLI::App& command);

    /// Throws Error (usage) for invalid options and invalid combinations.
    TextureRequest request() const;
};

} // namespace scree
