// SPDX-License-Identifier: GPL-3.0-or-later
// Settling: a component that has found a free place sinks and slides to where it rests.
#pragma once

#include "geometry/bodies/advance.h"
#include "geometry/mesh/nearest_surface.h"

namespace scree {

/// How components settle.
struct SettleSettings {
    int steps = 0;        // at most
    double turn = pi / 6; // by which they may turn at most [rad]
    double sink = 0;      // how deep below the ground their centres may lie, in radii
    double overlap = 0;   // T, in radii of the largest inner ball
};

/// Lets components sink towards a surface.
class Settler {
  public:
    /// `ground` has triangles and must outlive this.
    Settler(std::span<const PileKind> kinds, const Mesh& ground, const SettleSettings& settings);

    /// Lets a component that is free where it is sink towards the ground, slide and turn along
    /// those in its way (position-based, Mueller et al. 2020), until it rests on them or its centre
    /// is on the ground. In the end it is as free of all as `is_free` asks, not higher than at
    /// first, and not farther from there than its reach.
    Placed settle(const Pile& pile, const Placed& start) const;

  private:
    SettleSettings settings_;
    NearestSurface ground_;
    std::vector<Imath::M33d> inverse_inertias_; // of mass 1 about its origin, by kind
};

} // namespace scree
