// SPDX-License-Identifier: GPL-3.0-or-later
// The files that scenes are written to, and what of other programs' files a scene can name.
#pragma once

#include "core/registry.h"
#include "geometry/mesh/mesh.h"
#include "model/scene.h"

#include <functional>

namespace scree {

/// mesh.file: a mesh read from OBJ, PLY, STL or glTF by its ending. Errors (missing file, damaged
/// file, open mesh where a closed one is asked for, NaN positions) name the script's line.
Registry<Mesh(const Params& params)> mesh_file_table();

/// What of a scene a format holds, and so what its writer is given.
enum class Holds {
    generated, // what generators made: the scene comes without single objects
    solid      // likewise, and its components united to one closed surface
};

/// What a writer gets beside the scene.
struct ExportOptions {
    int pixels = 1600;           // of the longer side of a picture
    const Mesh* solid = nullptr; // what Holds::solid asks for [m]
};

/// A file format, by the ending of its files.
struct SceneFormat {
    std::string ending; // "json"
    Holds holds;
    /// Writes the file atomically. Throws Error (resource) on an unwritable path or a full disk.
    std::function<void(const Scene& scene, const std::string& path, const ExportOptions& options)>
        write;
};

std::vector<SceneFormat> scene_formats();

} // namespace scree
