// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/bodies/advance.h"

namespace scree {

/// A ray from a point of the target's surface that leaves the target without meeting it again: a
/// way on which that point is seen from outside.
struct OutsideRay {
    Imath::V3d origin;
    Vec3 normal; // of the surface there
    Vec3 direction;
};

/// About `count` of such rays: their points even over the surface, directions towards either side
/// of an open mesh and the outside of a closed one, cosine-weighted, those that meet the target
/// left out. `stream` counts independent sets of one seed.
std::vector<OutsideRay> outside_rays(const Mesh& target, std::size_t count, std::uint64_t seed,
                                     std::uint32_t stream);

/// The rays that no component lies in the way of; one that holds a ray's origin does too.
std::vector<OutsideRay> open_rays(const Pile& pile, const std::vector<OutsideRay>& rays);

} // namespace scree
