// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/bodies/pile_component.h"

namespace scree {

/// A component with how it is to be placed.
struct PileKind {
    PileComponent component;
    double weight = 1;
    std::uint32_t shapes = 1; // it and those after it are one kind in so many shapes; of these: 0
    double spacing = 1;       // C_radius
    double refine = 2;        // C_refine
    Vec3 rotation{0, 0, 0};   // widths of the ranges about u, v and w [rad]

    /// r C_radius [m]: two of it are the distance between sites.
    double distribution_radius() const { return component.distribution_radius * spacing; }
    /// How far outwards it may move [m].
    double range() const { return distribution_radius() * refine; }
};

/// One placed component.
struct Placed {
    std::uint32_t kind = 0;
    Pose pose;
    Vec3 normal{0, 1, 0}; // of the surface where it was set, outwards
    double height = 0;    // of its centre above there, along the normal [m]
};

} // namespace scree
