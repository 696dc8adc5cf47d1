// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/figures/no_fit.h"
#include "geometry/figures/placements.h"

namespace scree {

/// What the search for room knows of a component beforehand.
struct SearchShape {
    std::vector<NoFitPiece> pieces; // together they cover its region, within a fraction of epsilon
    std::vector<NoFitPiece> coarse; // in each of them one of fewer corners, for wide cells
    double turn_period = 2 * pi;    // the region looks the same after turning by this [rad]
    double turn_radius = 0;         // of its farthest point from the centre of transformation [m]
    bool smaller_is_easier = false; // wherever it fits, it also fits at smaller scales
};

/// A layout problem prepared for the search; all threads share it.
struct SearchProblem {
    const LayoutProblem& layout;
    double epsilon = 0; // the clearance with which nothing fits in the end [m]
    std::vector<SearchShape> shapes{};
    std::vector<NoFitPiece> outside{}; // around a domain in which elements must lie whole
    std::vector<NoFitPiece> inside{};  // parts of one in which their centres must lie

    double clearance = 0;       // of placed elements [m]
    double largest_margin = 0;  // [m]
    double safety = 0;          // bound of the errors by float arithmetic and slivers [m]
    float sliver = 0;           // areas thinner than this are ignored [m]
    double smallest_extent = 0; // motion within a cell whose middle is certainly free [m]
    double dart_extent = 0;     // motion within a cell worth a dart [m]
    double coarse_loss = 0;   // how much farther apart two coarse pieces may be than fine ones [m]
    double coarse_extent = 0; // motion above which coarse pieces are accurate enough [m]
    double place_share = 4;   // how much wider than its turn a cell may be

    /// `epsilon`: in metres. Throws as `check_epsilon`.
    SearchProblem(const LayoutProblem& problem, double epsilon);
};

/// Throws Error when `epsilon` [m] is too small for float arithmetic.
void check_epsilon(const LayoutProblem& problem, double epsilon);

/// About how long the search takes on one core [s], to a factor of three: what decides whether a
/// layout is saturated unless the script says. Measured: 0.14 ms for each element and each pair of
/// convex pieces, one of any component and one of the element (gears, letters, rings, stars, toys).
double expected_seconds(const LayoutProblem& problem);

/// The smallest turn after which the region looks the same [rad]: 2 pi or a whole part of it.
double turn_period(const Region& region);

} // namespace scree
