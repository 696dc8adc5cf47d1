// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/table.h"
#include "session/make_solid.h"

namespace scree {

/// The format of a file name's extension. Throws Error (usage) that lists the known ones.
const SceneFormat& scene_format(std::span<const SceneFormat> formats, const std::string& path);

/// The result of an export.
struct Exported {
    Scene scene;                        // the part of the scene that was written
    std::optional<Fabrication> solid{}; // set for Holds::solid
};

/// Writes the part of the scene that the format holds (stage "write") and reports to the watcher.
/// Throws Error when the scene contains nothing for the
/// format, and as `make_solid` and the writer do.
Exported export_scene(Session& session, Scene scene, const SceneFormat& format,
                      const std::string& path, const LayoutLook& look, const SolidOptions& solid);

} // namespace scree
