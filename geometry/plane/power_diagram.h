// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/math.h"

#include <array>
#include <cstdint>
#include <span>

namespace scree {

/// A cell of a power diagram, cut to the domain.
struct PowerCell {
    static constexpr std::int32_t border = -1;

    Ring ring;                        // convex, counter-clockwise; empty where the site has no cell
    std::vector<std::int32_t> beyond; // of the edge from each point to the next the other site, or
                                      // `border`
    double area = 0;                  // [m^2]
    Vec2 centroid{0.0, 0.0};
};

/// The cells of sites in a convex domain: of each the points p with |p - site|^2 - weight less than
/// for all other sites (Laguerre's diagram; Voronoi's where all weights are equal).
/// @param weights one for each site [m^2]
/// @param domain counter-clockwise
std::vector<PowerCell> power_diagram(std::span<const Vec2> sites, std::span<const double> weights,
                                     const Ring& domain);

/// Delaunay's triangulation of points, counter-clockwise.
std::vector<std::array<std::uint32_t, 3>> delaunay(std::span<const Vec2> points);

/// Weights and diagram with cells of prescribed areas.
struct PrescribedAreas {
    std::vector<double> weights; // [m^2]
    std::vector<PowerCell> cells;
    double error = 0; // greatest relative error of an area
    int steps = 0;    // of Newton's method
};

/// Finds the weights with which each site's cell has its area, by Newton's method on the concave
/// function whose gradient is areas - cells (Kitagawa, Mérigot & Thibert 2019), damped so that no
/// cell vanishes, until no area is off by more than `tolerance` of itself.
/// @param areas add up to that of the domain [m^2]
/// @param weights to begin with; empty: all 0
PrescribedAreas cells_of_areas(std::span<const Vec2> sites, std::span<const double> areas,
                               const Ring& domain, double tolerance,
                               std::vector<double> weights = {});

} // namespace scree
