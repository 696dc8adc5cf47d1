// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "formats/texture_source.h"
#include "model/scene.h"

namespace scree {

/// A mesh of the scene with the procedural that `scree texture` bakes.
struct TextureSubject {
    TextureSource source;
    WideMatrix world_from_object; // identity when it has several instances
    Location where;               // of the object or generator in the script
    std::string kind;             // "object", "generator.layout"
    bool is_object = false;       // and no generator
    bool scales_differ = false;   // of its instances: the texture is that of the first

    /// Errors about the mesh or the material, located in the script.
    Error mesh_error(const std::string& message, const std::string& hint = {}) const;
    Error material_error(const std::string& message, const std::string& hint = {}) const;
};

/// The subject of object `number`, counted from 1 in the order of scene.objects; 0 selects the only
/// object that has a procedural. Throws Error when there is no such object, when it has no
/// procedural or several, and when `number` is 0 but several objects have one.
TextureSubject texture_subject(const std::string& scene_path, const Scene& scene, int number);

} // namespace scree
