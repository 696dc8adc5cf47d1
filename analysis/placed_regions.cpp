// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/placed_regions.h"

#include <algorithm>
#include <cassert>

namespace scree {

namespace {

Vec2 image_of(const Vec2& p, const Matrix& m) {
    return {p.x * double(m[0][0]) + p.y * double(m[2][0]) + double(m[3][0]),
            p.x * double(m[0][2]) + p.y * double(m[2][2]) + double(m[3][2])};
}

// Into the window's rectangle, each coordinate in [min, max).
Vec2 wrapped(Vec2 p, const Box2& box) {
    for (int axis = 0; axis < 2; ++axis) {
        const double period = box.max[axis] - box.min[axis];
        p[axis] -= std::floor((p[axis] - box.min[axis]) / period) * period;
        if (p[axis] >= box.max[axis])
            p[axis] = box.min[axis];
    }
    return p;
}

} // namespace

Outline place(const Region& region, const Matrix& world_from_object) {
    Outline placed;
    double sum = 0;
    for (const Ring& ring : region.rings) {
        Ring& out = placed.emplace_back();
        for (const Vec2& point : ring)
            out.push_back(image_of(point, world_from_object));
        sum += signed_area(out);
    }
    if (sum < 0) // seen in a mirror
        for (Ring& ring : placed)
            std::reverse(ring.begin(), ring.end());
    return placed;
}

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
        const Vec2 position = image_of(centre, instance.world_from_object);
        placed.positions.push_back(aggregate.torus ? wrapped(position, box) : position);
        placed.kinds.push_back(instance.prototype);
        if (have_regions)
            placed.outlines.push_back(place(*region, instance.world_from_object));
    }
    return placed;
}

} // namespace scree
