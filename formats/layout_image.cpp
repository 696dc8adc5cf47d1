// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/canvas.h"
#include "core/display_encoding.h"
#include "formats/layout_picture.h"
#include "geometry/plane/ground_plane.h"

#include <algorithm>
#include <map>
#include <optional>

namespace scree {

namespace {

// Display-encoded colours of a layout that is not a texture.
const Color paper(1.0F, 1.0F, 1.0F);
const Color ground(0.955F, 0.95F, 0.94F);
const Color edge(0.2F, 0.2F, 0.22F);
const Color margin(0.6F, 0.6F, 0.63F);

Color linear_color(const Color& display) {
    return {linear_from_display(display.x), linear_from_display(display.y),
            linear_from_display(display.z)};
}

class LayoutImage {
  public:
    LayoutImage(const Box2& box, int width, int height, bool margins)
        : low_(box.min), scale_(width / box.size().x, height / box.size().y), margins_(margins),
          canvas_(width, height) {}

    void lay_paper() {
        const Vec2 far(double(canvas_.image().width), double(canvas_.image().height));
        const Ring sheet{{0, 0}, {far.x, 0}, far, {0, far.y}};
        canvas_.fill({&sheet, 1}, linear_color(paper));
    }

    void draw(const Aggregate& aggregate, const ElementColor& color) {
        if (aggregate.domain && !aggregate.texture)
            canvas_.fill(pixels(*aggregate.domain), linear_color(ground));
        if (is_tile(aggregate)) {
            const Box2 domain = bounds(*aggregate.domain);
            canvas_.clip({pixel(domain.min), pixel(domain.max)});
        }
        if (aggregate.background && aggregate.domain)
            draw_background(aggregate);
        // All copies of an element are drawn before the next element, so that the order of
        // overlapping elements is the same on both sides of a seam.
        for (const Instance& instance : aggregate.instances)
            for (const Vec2& shift : picture_shifts(aggregate))
                if (is_seen(aggregate, instance, shift))
                    draw(aggregate, instance, shift, color);
        canvas_.clip_nothing();
        if (aggregate.domain && !is_tile(aggregate))
            for (const Ring& ring : pixels(*aggregate.domain))
                canvas_.stroke(ring, 1.5, linear_color(edge), true);
    }

    Image& image() { return canvas_.image(); }

  private:
    Vec2 pixel(const Vec2& p) const { return (p - low_) * scale_; }

    std::vector<Ring> pixels(const Region& region) const {
        std::vector<Ring> rings = region.rings;
        for (Ring& ring : rings)
            for (Vec2& p : ring)
                p = pixel(p);
        return rings;
    }

    const PictureFilter& filter(const Picture& picture, Beyond beyond) {
        return filters_.try_emplace({&picture, beyond}, picture.image, beyond).first->second;
    }

    void draw_background(const Aggregate& aggregate) {
        const Box2 box = bounds(*aggregate.domain);
        const Vec2 low = pixel(box.min), size = pixel(box.max) - low;
        canvas_.draw(
            filter(*aggregate.background, aggregate.torus ? Beyond::repeated : Beyond::clamped),
            {low, {size.x, 0}, {0, size.y}});
    }

    void draw(const Aggregate& aggregate, const Instance& instance, const Vec2& shift,
              const ElementColor& color) {
        const Prototype& prototype = aggregate.prototypes[instance.prototype];
        const WideMatrix& matrix = instance.world_from_object;
        if (prototype.picture) {
            const Box2& box = prototype.picture->box;
            const auto at = [&](double x, double z) {
                return pixel(ground_point({x, z}, matrix) + shift);
            };
            const Vec2 origin = at(box.min.x, box.min.y);
            const PicturePlace place{origin, at(box.max.x, box.min.y) - origin,
                                     at(box.min.x, box.max.y) - origin};
            if (cross(place.u, place.v) != 0)
                canvas_.draw(filter(*prototype.picture, Beyond::clamped), place);
            return;
        }
        canvas_.fill(placed(seen_region(prototype), matrix, shift),
                     linear_color(color(aggregate, instance)));
        if (margins_ && has_margin(prototype))
            for (const Ring& ring : placed(*prototype.region, matrix, shift))
                canvas_.stroke(ring, 0.75, linear_color(margin), true);
    }

    std::vector<Ring> placed(const Region& region, const WideMatrix& matrix,
                             const Vec2& shift) const {
        Region moved = ground_region(region, matrix);
        for (Ring& ring : moved.rings)
            for (Vec2& p : ring)
                p += shift;
        return pixels(moved);
    }

    Vec2 low_;
    Vec2 scale_; // pixels per metre
    bool margins_;
    Canvas canvas_;
    std::map<std::pair<const Picture*, Beyond>, PictureFilter> filters_;
};

} // namespace

Image layout_image(std::span<const Aggregate> aggregates, const ElementColor& color,
                   const LayoutLook& look) {
    const Box2 box = picture_box(aggregates);
    const double scale = look.pixels / std::max(box.size().x, box.size().y);
    const auto pixels = [&](double length) {
        return std::max(1, static_cast<int>(std::lround(length * scale)));
    };
    LayoutImage out(box, pixels(box.size().x), pixels(box.size().y), look.margins);
    if (!are_textures(aggregates))
        out.lay_paper();
    for (const Aggregate& aggregate : aggregates)
        out.draw(aggregate, color);
    return std::move(out.image());
}

} // namespace scree
