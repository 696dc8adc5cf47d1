// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/context.h"
#include "generators/leather/leather_settings.h"
#include "geometry/plane/height_field.h"

namespace scree {

/// Profile of a crista: its height, 0 to 1, where the membrane is swollen to the share `swell`, 0
/// at the groove and 1 at the cell's highest point. From a parabola (`fullness` 0: soft flanks) to
/// the quarter of an ellipse (1: steep flanks and a flat top).
float crista_profile(float swell, float fullness);

/// Profile of a sulcus: its depth, 1 in the middle to 0, at `distance` from the middle of a groove
/// that is `width` wide at 1/e of its depth: the Gaussian bell, round at the bottom and without an
/// edge at the top. Both lengths in the same unit.
float sulcus_profile(float distance, float width);

/// What is measured while a relief is made.
struct ReliefFacts {
    std::size_t cells = 0;
    double fill = 0; // share of the tile that the cells' regions cover
    std::size_t pores = 0;
    float lowest = 0; // of the heights [m]
    float highest = 0;
};

/// What a relief is asked to be.
struct ReliefRequest {
    LeatherSettings settings;
    double size = 0;      // edge of the tile [m]
    int resolution = 0;   // pixels along the edge, even
    double direction = 0; // of the cells' long axes, from +x towards +z [rad]
    ReliefParts parts = ReliefParts::both;
    std::uint64_t seed = 0;
};

/// Makes the height map of a leather that tiles seamlessly: cells are placed as in Sakurai & Miyata
/// 2014, section 5.3, on a torus; cristae rise from their cells and sulci run between them, along
/// the generalised Voronoi diagram of the cells, so that no flat gaps stay. A vector displacement
/// when the shoulders overhang. Same bytes on any number of threads.
HeightField leather_relief(const ReliefRequest& request, const Context& context,
                           ReliefFacts* facts = nullptr);

} // namespace scree
