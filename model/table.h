// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of materials, lights, cameras and objects, and the declarations of film and scene.
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

Registry<MakeMaterial>
material_table();                    // material.matte, plastic, metal, glass, translucent, fibre
Registry<MakeLight> light_table();   // light.sky, sun, area
Registry<MakeCamera> camera_table(); // camera.perspective
Registry<MakeItem> object_table();   // object

/// The generators of a table as items of a scene. Input errors that they throw are located at the
/// constructor.
Registry<MakeItem> generator_items(const Registry<Generator>& table);

/// The parameters of the record film = { ... }.
std::vector<ParamSpec> film_params();
FilmSettings film_settings(const Params& film);

/// The parameters of `scene { ... }`, and the draft made from them, without name and settings.
std::vector<ParamSpec> scene_params();
SceneDraft scene_draft(const Params& scene);

} // namespace scree
