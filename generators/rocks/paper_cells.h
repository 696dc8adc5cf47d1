// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/context.h"
#include "generators/rocks/rocks_settings.h"

namespace scree::rocks {

/// A Voronoi cell that was chosen for a rock.
struct ChosenCell {
    Ring ring; // counter-clockwise
    std::size_t size_class = 0;
};

/// Cells of several Voronoi diagrams that do not overlap.
struct PaperCells {
    std::vector<ChosenCell> cells;
    std::vector<double> sites;  // of each class, how many were placed
    std::vector<double> wanted; // and how many eq. 1 asks for
    std::vector<double> shares; // of the ground, that its chosen cells have
};

/// Sakurai & Miyata's steps 1 and 2: for each class sites by dart throwing, N = A c_d / (pi
/// (r/2)^2) of them (eq. 1), each keeping others r/2 away, or r; their Voronoi diagram; then, from
/// the diagram with the largest cells on, cells in random order that overlap none taken before,
/// until the class has its share. Overlap is decided by the polygons, not by an image's pixels.
PaperCells paper_cells(const Ring& domain, const RocksSettings& settings, const Context& context);

} // namespace scree::rocks
