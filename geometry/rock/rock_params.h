// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/params.h"
#include "geometry/rock/rock_settings.h"

namespace scree {

/// What scripts say of a rock's shape, for every plug-in that makes rocks.
std::vector<ParamSpec> rock_specs();

/// Reads these, all but the seed. Throws Error, located, where c is more than b.
RockSettings rock_settings(const Params& params);

/// How many triangles a rock's mesh may have: 20 level^2 for a level from 4 to 64.
ParamSpec rock_triangles_spec(std::string doc, Value fallback);

/// The level of a mesh with as many triangles.
int rock_level(double triangles);

} // namespace scree
