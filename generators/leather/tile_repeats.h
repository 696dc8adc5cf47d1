// SPDX-License-Identifier: GPL-3.0-or-later
// How a tile lies on a mesh over whose UVs it repeats.
#pragma once

#include "geometry/mesh/mesh.h"

namespace scree {

/// How often a tile of `size` [m] repeats over the unit square of UVs along u and v: whole numbers,
/// so that closed surfaces stay seamless, as near to its true size as can be in the mean.
Vec2 tile_repeats(const Mesh& mesh, const Vec2& size);

/// The size that the tile then has in the mean [m].
Vec2 laid_size(const Mesh& mesh, const Vec2& size);

/// By which factor such a tile is drawn out, or pressed together, in the direction where that is
/// most: at least this much on the worst twentieth of the mesh's area. Infinite where UVs have no
/// area; 1 where the tile has its true size and shape everywhere.
double tile_stretch(const Mesh& mesh, const Vec2& size);

} // namespace scree
