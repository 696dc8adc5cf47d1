// SPDX-License-Identifier: GPL-3.0-or-later
// Settling: a body that has been put at a free place sinks and slides until it rests.
#pragma once

#include "geometry/bodies/advance.h"
#include "geometry/bodies/mass_properties.h"
#include "geometry/mesh/nearest_surface.h"

namespace scree {

/// How bodies settle.
struct SettleSettings {
    int steps = 0;        // at most
    double turn = pi / 6; // the greatest rotation from the start [rad]
    double sink = 0;      // how deep below the ground the centre may lie, in radii
    double overlap = 0;   // T, in radii of the smaller one's largest inner ball
};

/// Lets bodies sink towards a surface.
class Settler {
  public:
    /// `ground` has triangles and must outlive this.
    Settler(const Bodies& bodies, const Mesh& ground, const SettleSettings& settings);

    /// Lets a body that starts free of all others sink towards the ground, slide and turn along
    /// those in its way (position-based dynamics, Mueller et al. 2020), until it rests on them or
    /// its centre is on the ground. It ends free of all others by `is_free`, no higher than it
    /// started, and no farther from its start than its reach.
    PlacedBody settle(const PlacedBodies& bodies, const PlacedBody& start) const;

  private:
    SettleSettings settings_;
    NearestSurface ground_;
    std::vector<MassProperties> masses_; // of each shape
};

} // namespace scree
