// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/bodies/neighbour_hash.h"
#include "geometry/bodies/pose.h"

namespace scree {

/// One placed body.
struct PlacedBody {
    std::uint32_t body = 0; // its number among the bodies
    Pose pose;
    Vec3 normal{0, 1, 0}; // of the surface at the site where it was set, outwards
    double height = 0;    // of its centre above that site, along the normal [m]
};

/// A place on a surface at which a body is tried, with the body's rotation there.
struct BodySite {
    Imath::V3d position;
    Vec3 normal; // of the surface, outwards, of length 1
    Imath::M33f world_from_body;
    std::uint32_t body = 0; // its number among the bodies

    /// The body moved outwards by `height` [m].
    PlacedBody at(double height) const {
        return {body, {position + Imath::V3d(normal) * height, world_from_body}, normal, height};
    }
};

/// The bodies placed so far, found by where they are.
struct PlacedBodies {
    explicit PlacedBodies(Bodies shapes_of) : shapes(std::move(shapes_of)), hash(shapes) {}

    void add(const PlacedBody& placed);

    const Body& body(const PlacedBody& placed) const { return *shapes[placed.body]; }

    Bodies shapes; // of which all are copies
    std::vector<PlacedBody> all;
    NeighbourHash hash; // of the numbers in `all`
};

/// The reach of the largest of the bodies [m]; 0 where there are none.
double largest_reach(const Bodies& bodies);

} // namespace scree
