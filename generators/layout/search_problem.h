// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/figures/no_fit.h"
#include "geometry/figures/placements.h"

namespace scree {

/// What the search for room knows of a component beforehand.
struct SearchShape {
    std::vector<ConvexPiece> pieces; // together they cover its region, within a fraction of epsilon
    std::vector<ConvexPiece> coarse; // in each of them one of fewer corners, for wide cells
    double turn_period = 2 * pi;     // the region looks the same after turning by this [rad]
    double turn_radius = 0;          // of its farthest point from the centre of transformation [m]
    bool smaller_is_easier = false;  // what has room for it has room for it at smaller scales
};

/// A layout problem prepared for the search; all threads share it.
struct SearchProblem {
    const LayoutProblem& layout;
    double epsilon = 0; // the clearance with which nothing fits in the end [m]
    std::vector<SearchShape> shapes{};
    std::vector<ConvexPiece> outside{}; // around a domain in which elements must lie whole
    std::vector<ConvexPiece> inside{};  // parts of one in which their centres must lie

    double clearance = 0;       // of placed elements [m]
    double largest_margin = 0;  // [m]
    double safety = 0;          // what float arithmetic and slivers may add up to [m]
    float sliver = 0;           // areas thinner than this are as good as none [m]
    double smallest_extent = 0; // motion within a cell whose middle is certainly free [m]
    double dart_extent = 0;     // motion within a cell worth a dart [m]
    double coarse_loss = 0;     // what two of them may be farther apart than the pieces [m]
    double coarse_extent = 0;   // motion from which on coarse pieces will do [m]
    double place_share = 4;     // how much wider than its turn a cell may be

    /// `epsilon`: in metres. Throws Error when it is too small for float arithmetic.
    SearchProblem(const LayoutProblem& problem, double epsilon);
};

/// The smallest turn after which the region looks the same [rad]: 2 pi or a whole part of it.
double turn_period(const Region& region);

} // namespace scree
