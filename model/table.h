// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of what a scene is made of apart from shapes, generators and procedurals: materials,
// lights, camera, film, objects.
#pragma once

#include "core/registry.h"
#include "model/camera.h"
#include "model/film_settings.h"
#include "model/generator.h"
#include "model/light.h"
#include "model/material.h"
#include "model/scene.h"

namespace scree {

using MakeMaterial = Material(const Params& params);
using MakeLight = Light(const Params& params);
using MakeCamera = Camera(const Params& params);
using MakeItem = SceneItem(const Params& params);

Registry<MakeMaterial> material_table(); // material.matte, plastic, metal, glass, translucent
Registry<MakeLight> light_table();       // light.sky, sun, area
Registry<MakeCamera> camera_table();     // camera.perspective
Registry<MakeItem> object_table();       // object

/// The generators of a table as items of a scene. Errors they throw are given the constructor's
/// place in the script.
Registry<MakeItem> generator_items(const Registry<Bake>& table);

/// The scene's film = { ... } record.
std::vector<ParamSpec> film_params();
FilmSettings film_settings(const Params& film);

/// The parameters of `scene { ... }`, and the draft made from them, still without name and
/// settings.
std::vector<ParamSpec> scene_params();
SceneDraft scene_draft(const Params& scene);

} // namespace scree
