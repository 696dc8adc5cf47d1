// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/bodies/placed_bodies.h"

namespace scree {

/// A ray from a point of the target's surface that does not meet the target again: a direction from
/// which that point can be seen from outside.
struct OutsideRay {
    Imath::V3d origin;
    Vec3 normal; // of the surface there
    Vec3 direction;
};

/// The rays among `count` random ones that do not meet the target again. Their origins are even
/// over the surface; their directions are cosine-weighted, to the outside of a closed mesh and to
/// either side of an open one. Different values of `stream` give independent sets.
std::vector<OutsideRay> outside_rays(const Mesh& target, std::size_t count, std::uint64_t seed,
                                     std::uint32_t stream);

/// The rays that meet no component; one that contains a ray's origin counts as met.
std::vector<OutsideRay> open_rays(const PlacedBodies& pile, const std::vector<OutsideRay>& rays);

} // namespace scree
