// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/table.h"
#include "session/make_solid.h"

namespace scree {

/// The row of a file name's ending. Throws Error (usage) that lists those there are.
const SceneFormat& scene_format(std::span<const SceneFormat> formats, const std::string& path);

/// What was written.
struct Exported {
    Scene scene;                        // what the format holds of it
    std::optional<Fabrication> solid{}; // for Holds::solid
};

/// Writes what the format holds of the scene (stage "write") and tells the watcher. `pixels`: of
/// the longer side of a picture. Throws Error when there is nothing of that kind in the scene, and
/// as `make_solid` and the writer do.
Exported export_scene(Session& session, Scene scene, const SceneFormat& format,
                      const std::string& path, int pixels, const SolidOptions& solid);

} // namespace scree
