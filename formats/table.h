// SPDX-License-Identifier: GPL-3.0-or-later
// The table of formats that scenes are written to, and the shapes that scenes read from files.
#pragma once

#include "core/registry.h"
#include "core/warn.h"
#include "formats/layout_picture.h"
#include "geometry/mesh/mesh.h"
#include "geometry/mesh/strands.h"
#include "model/scene.h"

#include <functional>

namespace scree {

/// mesh.file: a mesh read from OBJ, PLY, STL, glTF or 3DS. Errors (missing or corrupt file, an open
/// mesh where a closed one is required, NaN positions) are located at the script's line.
Registry<Mesh(const Params& params)> mesh_file_table();

/// curve.file: strands read from the lines of an OBJ file or from a baked JSON file. Errors are
/// located at the script's line.
Registry<Strands(const Params& params)> curve_file_table();

/// Which part of a scene a format holds, and its writer is given.
enum class Holds {
    generated, // the output of generators: the scene without single objects
    solid      // the same, and the union of its components as one closed surface
};

/// Options of a writer.
struct ExportOptions {
    LayoutLook look;             // of a picture
    const Mesh* solid = nullptr; // the union of the components, for Holds::solid [m]
    Warn warn = no_warning;      // told what the format cannot hold
};

/// A file format, chosen by the file's extension.
struct SceneFormat {
    std::string ending; // "json"
    Holds holds;
    /// Writes the file atomically. Throws Error (resource) on an unwritable path or a full disk.
    std::function<void(const Scene& scene, const std::string& path, const ExportOptions& options)>
        write;
};

std::vector<SceneFormat> scene_formats();

} // namespace scree
