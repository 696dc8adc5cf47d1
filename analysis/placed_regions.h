// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/aggregate.h"

namespace scree {

/// The window in which points or regions were placed: a polygon with holes or, on a torus, an
/// axis-parallel rectangle whose opposite sides are identified. Only the rings are used.
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

/// The points with their regions. On a torus a region may extend beyond the window, whose opposite
/// side it then re-enters.
struct PlacedRegions : PlacedPoints {
    std::vector<Region> outlines; // placed region of each element, rings only [m]; empty: unknown
};

/// The elements of a layout. The position of an element is that of the centre of its region's
/// bounding box, or of its origin if it has no region. The aggregate must have a domain.
PlacedRegions placed_regions(const Aggregate& aggregate);

} // namespace scree
