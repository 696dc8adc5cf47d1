// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene_options.h"
#include "formats/texture_source.h"

namespace scree {

enum class TextureMap { uv, slices, volume };

/// What `scree texture` is asked for, checked.
struct TextureRequest {
    TextureMap map = TextureMap::uv;
    TextureChannel channel = TextureChannel::color;
    std::string ending; // of the file: png, exr, vdb
    int width = 0;      // pixels; voxels along the longest side
    int height = 0;     // 0: it follows
    int slices = 8;
    int axis = 2; // x, y or z
};

/// The options as they are typed.
struct TextureOptions {
    SceneOptions scene;
    std::string output;
    std::string stats;
    std::string map;
    std::string channel;
    std::string size;
    std::string axis;
    int object = 0; // 0: the only one
    int slices = 0; // 0: not given

    void add_to(CLI::App& command);

    /// Throws Error (usage) for what cannot be, or cannot be together.
    TextureRequest request() const;
};

} // namespace scree
