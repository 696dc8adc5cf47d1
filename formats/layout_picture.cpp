// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/layout_picture.h"

#include "core/error.h"
#include "geometry/plane/ground_plane.h"

#include <algorithm>

namespace scree {

bool is_tile(const Aggregate& aggregate) {
    return aggregate.domain && (aggregate.torus || aggregate.texture);
}

bool are_textures(std::span<const Aggregate> aggregates) {
    return std::all_of(aggregates.begin(), aggregates.end(),
                       [](const Aggregate& a) { return a.texture && a.domain; });
}

const Region& seen_region(const Prototype& prototype) {
    return prototype.outline ? *prototype.outline : *prototype.region;
}

bool has_margin(const Prototype& prototype) {
    return prototype.region && prototype.outline && !prototype.picture;
}

Box2 prototype_box(const Prototype& prototype) {
    Box2 box;
    if (prototype.region)
        box = bounds(*prototype.region);
    if (prototype.picture)
        box.extendBy(prototype.picture->box);
    return box;
}

Box2 picture_box(std::span<const Aggregate> aggregates) {
    Box2 box;
    for (const Aggregate& aggregate : aggregates) {
        if (aggregate.domain)
            box.extendBy(bounds(*aggregate.domain));
        if (is_tile(aggregate))
            continue; // nothing is drawn outside the domain
        for (const Instance& instance : aggregate.instances) {
            const Prototype& prototype = aggregate.prototypes[instance.prototype];
            if (prototype.region)
                box.extendBy(bounds(ground_region(*prototype.region, instance.world_from_object)));
            if (prototype.picture) {
                const Box2& area = prototype.picture->box;
                for (const Vec2& corner : {area.min, area.max, Vec2(area.min.x, area.max.y),
                                           Vec2(area.max.x, area.min.y)})
                    box.extendBy(ground_point(corner, instance.world_from_object));
            }
        }
    }
    if (box.isEmpty())
        throw Error("there is nothing to see from above: no generator has a domain, regions or "
                    "pictures");
    const bool tiles = std::all_of(aggregates.begin(), aggregates.end(), is_tile);
    const double border = tiles ? 0 : std::max(box.size().x, box.size().y) / 50;
    return {box.min - Vec2(border, border), box.max + Vec2(border, border)};
}

std::vector<Vec2> picture_shifts(const Aggregate& aggregate) {
    if (!aggregate.torus || !aggregate.domain)
        return {{0, 0}};
    const Vec2 period = bounds(*aggregate.domain).size();
    std::vector<Vec2> shifts;
    for (const double y : {-1.0, 0.0, 1.0})
        for (const double x : {-1.0, 0.0, 1.0})
            shifts.emplace_back(x * period.x, y * period.y);
    return shifts;
}

bool is_seen(const Aggregate& aggregate, const Instance& instance, const Vec2& shift) {
    const Box2 box = prototype_box(aggregate.prototypes[instance.prototype]);
    if (box.isEmpty())
        return false;
    if (!is_tile(aggregate))
        return true;
    const WideMatrix& m = instance.world_from_object;
    const double scale = // the Frobenius norm, an upper bound of the scale
        std::hypot(std::hypot(m[0][0], m[0][2]), std::hypot(m[2][0], m[2][2]));
    double reach = 0; // radius of the bounding circle about the prototype's origin
    for (const Vec2& corner :
         {box.min, box.max, Vec2(box.min.x, box.max.y), Vec2(box.max.x, box.min.y)})
        reach = std::max(reach, corner.length() * scale);
    reach *= 1 - 1e-9; // what only touches the domain, up to rounding, is not seen
    Box2 domain = bounds(*aggregate.domain);
    domain.min -= Vec2(reach, reach);
    domain.max += Vec2(reach, reach);
    return domain.intersects(Vec2(m[3][0], m[3][2]) + shift);
}

} // namespace scree
