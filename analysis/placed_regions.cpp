// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/placed_regions.h"

#include "geometry/plane/ground_plane.h"

#include <algorithm>
#include <cassert>

namespace scree {

namespace {

// Wraps a point into the rectangle of a torus, each coordinate in [min, max).
Vec2 wrapped(Vec2 p, const Box2& box) {
    for (int axis = 0; axis < 2; ++axis) {
        const double period = box.max[axis] - box.min[axis];
        p[axis] -= std::floor((p[axis] - box.min[axis]) / period) * period;
        if (p[axis] >= box.max[axis])
            p[axis] = box.min[axis];
    }
    return p;
}

// Restores the orientation of rings that a mirroring matrix has reversed.
Region turned_outwards(Region region) {
    if (area(region) < 0)
        for (Ring& ring : region.rings)
            std::reverse(ring.begin(), ring.end());
    return region;
}

} // namespace

PlacedRegions placed_regions(const Aggregate& aggregate) {
    assert(aggregate.domain != nullptr);
    PlacedRegions placed;
    placed.window = {aggregate.domain, aggregate.torus};
    for (const Prototype& prototype : aggregate.prototypes)
        placed.kind_names.push_back(prototype.name);
    const bool have_regions =
        std::all_of(aggregate.instances.begin(), aggregate.instances.end(), [&](const Instance& i) {
            return aggregate.prototypes[i.prototype].region != nullptr;
        });
    const Box2 box = bounds(*aggregate.domain);
    for (const Instance& instance : aggregate.instances) {
        const auto& region = aggregate.prototypes[instance.prototype].region;
        const Vec2 centre = region ? bounds(*region).center() : Vec2(0, 0);
        const Vec2 position = ground_point(centre, instance.world_from_object);
        placed.positions.push_back(aggregate.torus ? wrapped(position, box) : position);
        placed.kinds.push_back(instance.prototype);
        if (have_regions)
            placed.outlines.push_back(
                turned_outwards(ground_region(*region, instance.world_from_object)));
    }
    return placed;
}

} // namespace scree
