// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/texture_source.h"
#include "model/scene.h"

namespace scree {

/// What `scree texture` bakes: a mesh of the scene with its procedural.
struct TextureSubject {
    TextureSource source;
    Matrix world_from_object; // identity where it stands in several places
    Location where;           // of the object or generator in the script
    std::string kind;         // "object", "generator.layout"

    /// Errors about the mesh, by its name, and the material, with their place in the script.
    Error mesh_error(const std::string& message, const std::string& hint = {}) const;
    Error material_error(const std::string& message, const std::string& hint = {}) const;
};

/// The one of object `number` (counted from 1 in the order of scene.objects; 0: the only one that
/// has a procedural). Throws Error when there is no such object, when it has no procedural or
/// several, and when one must be named.
TextureSubject texture_subject(const std::string& scene_path, const Scene& scene, int number);

} // namespace scree
