// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/bodies/placed_bodies.h"

#include <algorithm>

namespace scree {

void PlacedBodies::add(const PlacedBody& placed) {
    hash.add(placed.body, static_cast<std::uint32_t>(all.size()), placed.pose.centre);
    all.push_back(placed);
}

double largest_reach(const Bodies& bodies) {
    double reach = 0;
    for (const auto& body : bodies)
        reach = std::max(reach, body->reach);
    return reach;
}

} // namespace scree
