// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/plane/svg/svg_viewport.h"

#include "core/text.h"

#include <fmt/format.h>

#include <algorithm>

namespace scree {

namespace {

/// A width or height; `outer` when it is not given or is a share of what is not known.
double side(const SvgProperties& properties, const char* name, double outer,
            const SvgLengths& lengths) {
    const std::string text = properties.keyword(name, "auto");
    if (text == "auto" || (text.ends_with('%') && outer == 0))
        return outer;
    const double length = parse_length(text, lengths.base(name));
    if (length < 0)
        throw Error(fmt::format("{}: is negative: {}", name, text));
    return length;
}

/// `user` units from `origin` fitted into `size` as preserveAspectRatio says.
Affine fitted(const Vec2& origin, const Vec2& user, const Vec2& size, const std::string& aspect) {
    Vec2 scale = size / user;
    if (!aspect.starts_with("none"))
        scale = Vec2(aspect.ends_with("slice") ? std::max(scale.x, scale.y)
                                               : std::min(scale.x, scale.y));
    // The rest of the room goes before the box: none of it for Min, half for Mid, all for Max.
    const auto share = [&](const char* low, const char* high) {
        return aspect.find(low) != std::string::npos    ? 0.0
               : aspect.find(high) != std::string::npos ? 1.0
                                                        : 0.5;
    };
    const Vec2 room = size - user * scale;
    Affine out;
    out.setScale(scale);
    Affine move;
    move.setTranslation(Vec2(room.x * share("xMin", "xMax"), room.y * share("YMin", "YMax")) -
                        origin * scale);
    return out * move;
}

std::string text_of(const std::string* attribute) {
    return attribute == nullptr ? std::string() : std::string(trimmed(*attribute));
}

} // namespace

SvgViewport svg_viewport(const SvgNode& node, const SvgProperties& properties,
                         const SvgLengths& outer, const SvgProperties* use) {
    SvgViewport out;
    const auto of_side = [&](const char* name, double whole) {
        const bool from_use = use != nullptr && use->keyword(name, "auto") != "auto";
        const double length = side(from_use ? *use : properties, name, whole, outer);
        out.drawn = out.drawn && (length > 0 || whole == 0);
        return length;
    };
    out.size = {of_side("width", outer.viewport.x), of_side("height", outer.viewport.y)};
    if (node.parent != nullptr && node.name == "svg") {
        const Attribute attribute{
            [&](const std::string& name) { return properties.get(name, "0"); }, outer};
        out.at = {svg_length(attribute, "x", 0), svg_length(attribute, "y", 0)};
    }
    out.inner = out.size;
    if (const std::string* box = node.attribute("viewBox")) {
        const std::vector<double> numbers = parse_numbers(*box);
        if (numbers.size() != 4 || !(numbers[2] > 0) || !(numbers[3] > 0))
            throw Error(fmt::format("viewBox: expected x, y, and a width and height above 0, got "
                                    "\"{:.40}\"",
                                    *box));
        out.inner = {numbers[2], numbers[3]};
        // One side given alone keeps the box's proportions, none its size.
        if (out.size.x == 0)
            out.size.x = out.size.y == 0 ? out.inner.x : out.size.y * out.inner.x / out.inner.y;
        if (out.size.y == 0)
            out.size.y = out.size.x * out.inner.y / out.inner.x;
        out.outer_from_inner = fitted({numbers[0], numbers[1]}, out.inner, out.size,
                                      text_of(node.attribute("preserveAspectRatio")));
    }
    Affine move;
    move.setTranslation(out.at);
    out.outer_from_inner = out.outer_from_inner * move;
    return out;
}

} // namespace scree
