// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/layout_picture.h"

#include "core/canvas.h"
#include "core/error.h"
#include "core/ground_plane.h"

#include <algorithm>

namespace scree {

Box2 picture_box(std::span<const Aggregate> aggregates) {
    Box2 box;
    for (const Aggregate& aggregate : aggregates) {
        if (aggregate.domain)
            box.extendBy(bounds(*aggregate.domain));
        if (aggregate.torus)
            continue; // nothing is drawn outside
        for (const Instance& instance : aggregate.instances)
            if (const auto& region = aggregate.prototypes[instance.prototype].region; region)
                box.extendBy(bounds(ground_region(*region, instance.world_from_object)));
    }
    if (box.isEmpty())
        throw Error("there is nothing to see from above: no generator has a domain or regions");
    const double border = std::max(box.size().x, box.size().y) / 50;
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

Image layout_image(std::span<const Aggregate> aggregates, const ElementColor& color,
                   int longest_side) {
    const Box2 box = picture_box(aggregates);
    const double scale = longest_side / std::max(box.size().x, box.size().y);
    const auto pixels = [&](double length) {
        return std::max(1, static_cast<int>(std::lround(length * scale)));
    };
    Canvas canvas(pixels(box.size().x), pixels(box.size().y), Color(1, 1, 1));
    const auto to_pixels = [&](const Vec2& p) { return (p - box.min) * scale; };
    const auto outline = [&](const Aggregate& aggregate) {
        std::vector<Ring> rings;
        for (const Ring& ring : aggregate.domain->rings)
            std::transform(ring.begin(), ring.end(), std::back_inserter(rings.emplace_back()),
                           to_pixels);
        return rings;
    };
    for (const Aggregate& aggregate : aggregates) {
        if (aggregate.domain)
            canvas.fill(outline(aggregate), Color(0.955F, 0.95F, 0.94F));
        if (aggregate.torus && aggregate.domain) {
            const Box2 domain = bounds(*aggregate.domain);
            canvas.clip({to_pixels(domain.min), to_pixels(domain.max)});
        }
        for (const Vec2& shift : picture_shifts(aggregate))
            for (const Instance& instance : aggregate.instances) {
                const auto& region = aggregate.prototypes[instance.prototype].region;
                if (!region)
                    continue;
                Region placed = ground_region(*region, instance.world_from_object);
                for (Ring& ring : placed.rings)
                    for (Vec2& p : ring)
                        p = to_pixels(p + shift);
                canvas.fill(placed.rings, color(aggregate, instance));
            }
        canvas.clip_nothing();
        if (aggregate.domain)
            for (const Ring& ring : outline(aggregate))
                canvas.stroke(ring, 1.5, Color(0.2F, 0.2F, 0.22F), true);
    }
    return canvas.image();
}

} // namespace scree
