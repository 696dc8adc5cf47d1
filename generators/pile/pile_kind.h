// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/bodies/body.h"

#include <span>

namespace scree {

/// What the bodies of a pile are made of, and how they are distributed. A component that comes in
/// several shapes has one kind for each shape, one after the other; sites are found for the first.
struct PileKind {
    std::shared_ptr<const Body> body;
    double unit_radius = 0; // see `unit_radius_of` [m]
    double weight = 1;      // how often the component is tried; 0 for all its shapes but the first
    std::uint32_t shapes = 1; // how many the component has; 0 for all but the first
    double spacing = 1;       // C_radius of Sakurai (2013)
    double refine = 2;        // C_refine
    Vec3 rotation{0, 0, 0};   // widths of the ranges of random angles about u, v and w [rad]

    /// r C_radius [m]: sites are twice that apart.
    double distribution_radius() const { return unit_radius * spacing; }
    /// How far outwards the body may move [m].
    double range() const { return distribution_radius() * refine; }
};

/// r of Sakurai (2013) [m]: half the radius of the largest inner ball; of a sheet a quarter of the
/// radius of a disk of its area.
double unit_radius_of(const Body& body);

/// The bodies of all kinds, in their order.
Bodies bodies_of(std::span<const PileKind> kinds);

/// How far outwards the body of each kind may move [m].
std::vector<double> ranges_of(std::span<const PileKind> kinds);

/// The kind at `share`, from 0 to 1, of the sum of all weights: a random kind by weight for a
/// random share.
std::uint32_t kind_at(std::span<const PileKind> kinds, double share);

} // namespace scree
