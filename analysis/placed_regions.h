// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/aggregate.h"

namespace scree {

/// Where points or regions were placed. On a torus `domain` is an axis-parallel rectangle whose
/// opposite sides are one; otherwise a polygon with holes. Only the rings are read.
struct Window {
    std::shared_ptr<const Region> domain;
    bool torus = false;
};

/// Points of several kinds in a window.
struct PlacedPoints {
    Window window;
    std::vector<Vec2> positions;      // [m]
    std::vector<std::uint32_t> kinds; // as many as positions, each below `kind_names.size()`
    std::vector<std::string> kind_names;
};

/// The points with the region around each; `outlines` is empty when regions are unknown. On a torus
/// a region may stick out of the window; what sticks out lies at the opposite side.
struct PlacedRegions : PlacedPoints {
    std::vector<Region> outlines; // per element where it was placed, rings only [m]
};

/// The elements of a layout: an element's position is the image of the centre of its region's
/// bounding box, or of the origin where it has none. Needs a domain.
PlacedRegions placed_regions(const Aggregate& aggregate);

} // namespace scree
