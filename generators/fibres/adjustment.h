// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/context.h"
#include "generators/fibres/nearest_vertices.h"
#include "generators/fibres/rotation.h"
#include "geometry/mesh/signed_distance_grid.h"

#include <span>
#include <vector>

namespace scree::fibres {

/// Where a fibre is: its vertices are the local ones, turned and then moved.
struct Pose {
    Vec3 centre; // of its vertices [m]
    Rotation rotation{};
    float unused = 0; // to eight numbers, as adjust.cl reads them
};

/// Fibres as rigid bodies.
struct RigidFibres {
    std::uint32_t vertices = 0; // of each
    std::vector<Vec3> local{};  // vertices about their centroid [m], fibre after fibre
    std::vector<Pose> poses{};
};

/// Fits fibres into the target: minimises half the sum of max(0, distance + 1.05 radius)^2 over
/// their vertices by damped Gauss-Newton steps, until no fibre moves over 0.05 radius, at most 35
/// times. On the context's device, or as C++ without one. Returns the number of iterations.
int adjust_nearest(RigidFibres& fibres, const SignedDistanceGrid& target, double radius,
                   const Context& context);

/// Fits them as Sakurai 2013, 5.2.2.2: in each iteration every fibre that is not wholly inside
/// takes the best of 12 moves by eq. 5.2, 0.02 of its length along each axis and 2 degrees about
/// each, until the number of vertices outside falls by less than 0.5%. `lengths`: of the fibres
/// [m]. The thesis leaves steps, angle and end open. Returns the number of iterations.
int adjust_thesis(RigidFibres& fibres, const NearestVertices& target,
                  std::span<const float> lengths, const Context& context);

} // namespace scree::fibres
