// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that a scene can name, with its parameters.
#pragma once

#include "formats/table.h"
#include "generators/table.h"
#include "procedurals/table.h"
#include "render/table.h"

namespace scree {

/// The tables of all folders, made once.
struct Tables {
    Registry<MakeMesh> mesh{"mesh"}; // components and mesh.file
    Registry<MakeRegion> region = region_table();
    Registry<MakeField> field = field_table();
    Registry<Bake> generator = generator_table();
    Registry<MakeProcedural> procedural = procedural_table();
    Registry<MakeMaterial> material = material_table();
    Registry<MakeLight> light = light_table();
    Registry<MakeCamera> camera = camera_table();
    Registry<MakeFilm> film = film_table();

    Tables();
};
const Tables& tables();

/// What `object { ... }` may hold.
const std::vector<ParamSpec>& object_params();

/// One thing that a scene can name. Defaults and values are in the program's units (radians),
/// `min` and `max` in those of scripts (degrees).
struct PluginRow {
    std::string family; // "mesh"; "" for scene, object and film
    std::string name;   // "banana"
    std::string doc;
    std::vector<ParamSpec> params;
};

/// All rows of all tables, and scene, object and film, for `scree list` and the reference page.
std::vector<PluginRow> all_plugins();

} // namespace scree
