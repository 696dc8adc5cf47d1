// SPDX-License-Identifier: GPL-3.0-or-later
// The closed sets of the renderer and their declarations, for the scene reader and `scree list`.
#pragma once

#include "core/registry.h"
#include "render/camera.h"
#include "render/film_settings.h"
#include "render/lights.h"
#include "render/materials.h"

namespace scree {

using MakeMaterial = Material(const Params& params);
using MakeLight = Light(const Params& params);
using MakeCamera = Camera(const Params& params);
using MakeFilm = FilmSettings(const Params& params);

Registry<MakeMaterial> material_table(); // material.matte, plastic, metal, glass, translucent
Registry<MakeLight> light_table();       // light.sky, sun, area
Registry<MakeCamera> camera_table();     // camera.perspective
Registry<MakeFilm> film_table();         // one row, "film": the scene's film = { ... } record

} // namespace scree
