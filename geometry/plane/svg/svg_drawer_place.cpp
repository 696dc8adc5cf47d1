// SPDX-License-Identifier: GPL-3.0-or-later
// Where an element of a drawing is drawn: transforms and clips, and what is told of it.
#include "core/text.h"
#include "geometry/plane/svg/css_transform.h"
#include "geometry/plane/svg/svg_drawer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace scree {

namespace {

constexpr std::size_t most_nested_clips = 20;

/// What moves or cuts the element in a way that is not read.
void refuse_unread(const SvgNode& node, const SvgProperties& properties) {
    for (const char* name :
         {"mask", "mask-image", "-webkit-mask", "-webkit-mask-image", "offset-path"}) {
        const std::string value = properties.keyword(name, "none");
        if (value != "none")
            node.fail(fmt::format("{}: {}: \"{:.40}\" is not read", node.name, name, value));
    }
}

/// The id in `url(#id)`; empty for other values.
std::string id_in_url(std::string_view value) {
    if (!lower_case(value).starts_with("url("))
        return {};
    const std::size_t close = std::min(value.find(')'), value.size());
    std::string_view inside = trimmed(value.substr(4, close - 4));
    if (inside.size() >= 2 && (inside.front() == '"' || inside.front() == '\''))
        inside = trimmed(inside.substr(1, inside.size() - 2));
    return inside.starts_with('#') ? std::string(inside.substr(1)) : std::string();
}

std::string in_words(const char* what, const SvgNode& first, std::size_t count) {
    return fmt::format("line {}: {}: {}{}", first.line, first.name, what,
                       count == 1   ? ""
                       : count == 2 ? "; 1 more is like it"
                                    : fmt::format("; {} more are like it", count - 1));
}

Box2 tight_box(const std::vector<SvgShape>& shapes) {
    Box2 box;
    for (const SvgShape& shape : shapes) {
        const Box2 control = shape.path.control_box();
        const double size = control.isEmpty() ? 0 : (control.max - control.min).length();
        if (!(size > 0))
            continue;
        std::size_t points = 0;
        for (const Ring& ring : shape.path.flatten(1e-5 * size, points, 1'000'000))
            for (const Vec2& v : ring)
                box.extendBy(v);
    }
    return box;
}

} // namespace

SvgDrawer::Place SvgDrawer::inside(const SvgNode& node, const SvgProperties& properties,
                                   const Place& outer) {
    Place place = outer;
    place.style = styles_.computed(node, properties, outer.style);
    node.located([&] {
        place.pixel_from_user = transform(node, properties, place) * place.pixel_from_user;
        return 0;
    });
    if (outer.purpose == Purpose::measure)
        return place;
    refuse_unread(node, properties);
    clip(node, properties, place);
    if (place.purpose == Purpose::fill && place.style.opacity > 0 &&
        properties.keyword("filter", "none") != "none")
        filters_.add(node);
    return place;
}

Affine SvgDrawer::transform(const SvgNode& node, const SvgProperties& properties,
                            const Place& place) {
    const std::optional<std::string> by_css = properties.css("transform");
    const std::string* attribute = node.attribute("transform");
    const auto own = [&](const char* name) {
        const std::optional<std::string> value = properties.css(name);
        return value && lower_case(*value) != "none"
                   ? fmt::format("{}({}) ", name, *value) // blanks are as good as commas
                   : std::string();
    };
    const std::string before = own("translate") + own("rotate") + own("scale");
    if (!by_css && attribute == nullptr && before.empty())
        return {};
    const std::string kind = properties.keyword("transform-box", "view-box");
    const double unknown = std::nan("");
    Box2 box(Vec2(0.0), {place.viewport.x > 0 ? place.viewport.x : unknown,
                         place.viewport.y > 0 ? place.viewport.y : unknown});
    if (kind == "fill-box" || kind == "content-box" || kind == "stroke-box" ||
        kind == "border-box") {
        if ((kind == "stroke-box" || kind == "border-box") && place.style.stroked)
            throw Error(fmt::format("transform-box: {} is not read of what has a stroke", kind));
        box = object_box(node, properties, place);
    } else if (kind != "view-box") {
        throw Error(fmt::format("transform-box: expected view-box, fill-box, content-box, "
                                "stroke-box or border-box, got \"{:.30}\"",
                                kind));
    }
    const Vec2 size = box.max - box.min;
    const std::string origin = properties.get("transform-origin", "0 0").value_or("0 0");
    Affine there, back;
    back.setTranslation(css_transform_origin(origin, box, place.style.font_size));
    there.setTranslation(-css_transform_origin(origin, box, place.style.font_size));
    Affine matrix = by_css                 ? css_transform(*by_css, size, place.style.font_size)
                    : attribute != nullptr ? parse_transform(*attribute)
                                           : Affine();
    matrix = matrix * css_transform(before, size, place.style.font_size);
    return there * matrix * back;
}

Box2 SvgDrawer::object_box(const SvgNode& node, const SvgProperties& properties,
                           const Place& place) {
    Place measured;
    measured.style = place.style;
    measured.viewport = place.viewport;
    measured.purpose = Purpose::measure;
    std::vector<SvgShape> shapes;
    std::vector<SvgShape>* before = std::exchange(out_, &shapes);
    draw_content(node, properties, measured);
    out_ = before;
    const Box2 box = tight_box(shapes);
    return box.isEmpty() ? Box2(Vec2(0.0), Vec2(0.0)) : box;
}

std::size_t SvgDrawer::add_clip(std::vector<SvgShape> shapes) {
    drawing_.clips.push_back(std::move(shapes));
    return drawing_.clips.size() - 1;
}

SvgStyle SvgDrawer::style_around(const SvgNode& node) const {
    if (node.parent == nullptr)
        return {};
    const SvgStyle outer = style_around(*node.parent);
    return styles_.computed(*node.parent, styles_.properties(*node.parent, outer), outer);
}

void SvgDrawer::clip(const SvgNode& node, const SvgProperties& properties, Place& place) {
    const std::optional<std::string> value =
        node.located([&] { return properties.get("clip-path", "none"); });
    if (!value || lower_case(*value) == "none")
        return;
    const SvgNode* clip_path = styles_.find(id_in_url(*value));
    if (clip_path == nullptr || clip_path->name != "clipPath")
        node.fail(fmt::format("{}: clip-path: \"{:.40}\" is not read, expected none or the "
                              "url(#id) of a clipPath in the file",
                              node.name, *value));
    const std::string* units = clip_path->attribute("clipPathUnits");
    if (units == nullptr || *units != "objectBoundingBox") {
        place.within.push_back(clip_of(*clip_path, place, nullptr));
        return;
    }
    const Box2 box = object_box(node, properties, place);
    place.within.push_back(clip_of(*clip_path, place, &box));
}

/// The clip of an element at the place `clipped`; `box` is its bounds when the clip is in shares of
/// them.
std::size_t SvgDrawer::clip_of(const SvgNode& clip_path, const Place& clipped, const Box2* box) {
    if (std::count(open_.begin(), open_.end(), &clip_path) > 0 || open_.size() > most_nested_clips)
        clip_path.fail("clipPath: is used in itself");
    Place place;
    place.style = style_around(clip_path);
    place.viewport = clipped.viewport;
    place.purpose = Purpose::clip;
    place.pixel_from_user = clipped.pixel_from_user;
    if (box != nullptr) {
        const Vec2 size = box->max - box->min;
        place.pixel_from_user =
            Affine(size.x, 0, 0, 0, size.y, 0, box->min.x, box->min.y, 1) * place.pixel_from_user;
    }
    open_.push_back(&clip_path);
    place = inside(clip_path, styles_.properties(clip_path, place.style), place);
    std::vector<SvgShape> shapes;
    std::vector<SvgShape>* before = std::exchange(out_, &shapes);
    for (const std::unique_ptr<SvgNode>& child : clip_path.children)
        if (is_svg_shape(child->name) || child->name == "use" || child->name == "text")
            draw(*child, place); // nothing else clips (SVG 1.1, section 14.3.5)
    out_ = before;
    open_.pop_back();
    return add_clip(std::move(shapes));
}

void SvgDrawer::note_left_out(const SvgNode& node, const SvgProperties& properties,
                              const Place& place, const BezierPath& path) {
    if (place.style.stroked)
        strokes_.add(node);
    for (const char* name : {"marker", "marker-start", "marker-mid", "marker-end"})
        if (properties.keyword(name, "none") != "none") {
            markers_.add(node);
            break;
        }
    if (!place.style.fills() || page_.isEmpty())
        return;
    const Vec2 slack = (page_.max - page_.min) * 1e-3;
    const Box2 page(page_.min - slack, page_.max + slack);
    const auto inside = [&](const Box2& box) {
        return box.isEmpty() || (page.intersects(box.min) && page.intersects(box.max));
    };
    if (!inside(path.control_box()) && !inside(tight_box({{path, FillRule::nonzero, {}}})))
        beyond_.add(node);
}

void SvgDrawer::tell(const Warn& warn) const {
    const auto tell_of = [&](const LeftOut& left, const char* what) {
        if (left.count > 0)
            warn(in_words(what, *left.first, left.count));
    };
    tell_of(strokes_, "its stroke is no part of the region, which is what is filled");
    tell_of(markers_, "its markers are not read");
    tell_of(filters_, "its filter is not read");
    tell_of(beyond_, "reaches beyond the drawing's page, which does not cut it");
}

} // namespace scree
