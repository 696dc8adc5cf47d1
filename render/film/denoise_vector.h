// SPDX-License-Identifier: GPL-3.0-or-later
// The inner loops of denoise(), on tiles of Planes::tile_width x tile_height pixels.
#pragma once

#include "render/film/planes.h"

namespace scree {

/// A layer is Planes of four: three channels and the variance of each of them.
inline constexpr int layer_variance = 3;
inline constexpr int layer_planes = 4;

/// What light is fitted to.
struct DenoiseLayers {
    const Planes& light; // radiance over albedo
    const Planes& albedo;
    const Planes& normal;
    const Planes& trust; // one plane: 1 where a pixel has samples; 0 elsewhere, and in the border
};

/// NL-means of a layer of features: like neighbours are averaged, as far as the layer's variance
/// makes them differ (Rousselle, Knaus & Zwicker 2012, equations 3 and 4). Writes the tile at x, y
/// of the first three planes of `smooth`.
void smooth_tile(const Planes& layer, const Planes& trust, Planes& smooth, int x, int y);

/// The light of the pixels of the tile at x, y, fitted as a linear function of albedo and normal to
/// the neighbours whose light and features are alike. Writes three planes of `fitted`.
void fit_tile(const DenoiseLayers& layers, Planes& fitted, int x, int y);

} // namespace scree
