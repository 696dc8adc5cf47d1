// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/plane/svg/svg_drawer.h"

#include "core/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <ranges>

namespace scree {

namespace {

using Names = std::vector<std::string_view>;

// Groups, whose children are drawn.
const Names groups{"svg", "g", "a", "switch"};
// What draws nothing by itself.
const Names undrawn{"defs",
                    "symbol",
                    "clipPath",
                    "mask",
                    "marker",
                    "pattern",
                    "linearGradient",
                    "radialGradient",
                    "filter",
                    "metadata",
                    "title",
                    "desc",
                    "style",
                    "script",
                    "view",
                    "font",
                    "font-face",
                    "animate",
                    "set",
                    "cursor",
                    "meshgradient",
                    "animateTransform",
                    "animateMotion",
                    "solidcolor",
                    "hatch"};
// What has an area that is not read.
const Names unread{"text", "image", "foreignObject"};

constexpr std::size_t deepest = 200;
constexpr std::size_t most_elements = 200'000; // clones of clones soon are millions
constexpr double largest = 1e15;               // [pixels]

bool is_one_of(std::string_view name, const Names& names) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// The conditions of SVG 1.1, section 5.8.5. No extension is known, the language is English, and
/// of the features HTML in a foreignObject is missing.
bool conditions_hold(const SvgNode& node) {
    if (node.attribute("requiredExtensions") != nullptr)
        return false;
    if (const std::string* features = node.attribute("requiredFeatures"))
        if (node.name == "foreignObject" && features->find("Extensibility") != std::string::npos)
            return false;
    const std::string* languages = node.attribute("systemLanguage");
    if (languages == nullptr)
        return true;
    const std::vector<std::string_view> all = css_split(*languages, ',');
    return std::any_of(all.begin(), all.end(), [](std::string_view language) {
        const std::string small = lower_case(trimmed(language));
        return small == "en" || small.starts_with("en-");
    });
}

/// Elements of other spaces (sodipodi:namedview) are not the drawing's.
bool is_foreign(const SvgNode& node) { return node.name.find(':') != std::string::npos; }

/// An attribute of a shape's geometry, which may be given as a property (SVG 2, section 7).
std::optional<std::string> geometry_property(const SvgNode& node, const SvgProperties& properties,
                                             const std::string& name) {
    if (name == "points" || (name == "d" && !properties.css("d"))) {
        const std::string* attribute = node.attribute(name);
        return attribute == nullptr ? std::nullopt : std::optional(*attribute);
    }
    const std::optional<std::string> value = properties.get(name, "auto");
    if (name != "d")
        return value && lower_case(*value) == "auto" ? std::nullopt : value;
    const std::string_view data = value ? std::string_view(*value) : "none";
    if (lower_case(data) == "none")
        return "none";
    const std::size_t open = data.find_first_of("\"'");
    const std::size_t close = data.find_last_of("\"'");
    if (!lower_case(data).starts_with("path(") || open == std::string_view::npos || close <= open)
        throw Error(fmt::format("d: expected path(\"...\"), got \"{:.40}\"", data));
    return std::string(data.substr(open + 1, close - open - 1));
}

BezierPath rectangle_path(const Box2& box) {
    BezierPath path;
    path.move_to(box.min);
    path.line_to({box.max.x, box.min.y});
    path.line_to(box.max);
    path.line_to({box.min.x, box.max.y});
    path.close();
    return path;
}

/// Of a switch: the first child that can be drawn.
const SvgNode* chosen(const SvgNode& node) {
    for (const std::unique_ptr<SvgNode>& child : node.children)
        if (!is_foreign(*child) && !is_one_of(child->name, undrawn) && conditions_hold(*child))
            return child.get();
    return nullptr;
}

} // namespace

SvgDrawing SvgDrawer::drawn(const std::string& id, const Warn& warn) {
    out_ = &drawing_.shapes;
    if (id.empty()) {
        draw(root_, {});
        tell(warn);
        return std::move(drawing_);
    }
    const SvgNode* node = styles_.find(id);
    if (node == nullptr)
        throw Error(Diagnostic{{},
                               {},
                               fmt::format("no element has the id \"{}\"", id),
                               did_you_mean(id, styles_.ids())});
    std::vector<const SvgNode*> around;
    for (const SvgNode* outer = node->parent; outer != nullptr; outer = outer->parent)
        around.push_back(outer);
    Place place;
    for (const SvgNode* outer : std::ranges::reverse_view(around)) {
        const SvgProperties properties = styles_.properties(*outer, place.style);
        place = inside(*outer, properties, place);
        if (outer->name == "svg")
            enter_viewport(*outer, properties, nullptr, place);
    }
    // Asked for by name: what hides or cuts the elements around it does not hide it.
    place.style.visible = true;
    place.style.opacity = 1;
    place.within.clear();
    page_ = {};
    filters_ = {};
    if (is_one_of(node->name, undrawn))
        draw_children(*node, inside(*node, styles_.properties(*node, place.style), place));
    else
        draw(*node, place);
    tell(warn);
    return std::move(drawing_);
}

void SvgDrawer::draw(const SvgNode& node, const Place& outer, const SvgProperties* use) {
    if (++elements_ > most_elements)
        node.fail(fmt::format("more than {} elements are drawn, with clones", most_elements));
    if (is_foreign(node) || !conditions_hold(node))
        return;
    const bool shown_symbol = use != nullptr && node.name == "symbol";
    if (is_one_of(node.name, undrawn) && !shown_symbol)
        return;
    const SvgProperties properties = styles_.properties(node, outer.style);
    if (node.located([&] { return properties.keyword("display", "inline"); }) == "none")
        return;
    Place place = inside(node, properties, outer);
    if ((node.name == "svg" || shown_symbol) && !enter_viewport(node, properties, use, place))
        return;
    draw_content(node, properties, place);
}

void SvgDrawer::draw_content(const SvgNode& node, const SvgProperties& properties,
                             const Place& place) {
    if (node.name == "switch") {
        if (const SvgNode* child = chosen(node))
            draw(*child, place);
    } else if (is_one_of(node.name, groups) || node.name == "symbol") {
        draw_children(node, place);
    } else if (node.name == "use") {
        draw_use(node, properties, place);
    } else if (is_svg_shape(node.name) || node.name == "line") {
        draw_shape(node, properties, place);
    } else if (is_one_of(node.name, unread)) {
        const bool seen = place.purpose == Purpose::fill && node.name == "text"
                              ? place.style.fills()
                              : place.style.visible && place.style.opacity > 0;
        if (seen)
            node.fail(fmt::format("{} is not read; convert it to a path", node.name));
    } else {
        node.fail(fmt::format("unknown element \"{:.30}\"", node.name));
    }
}

void SvgDrawer::draw_children(const SvgNode& node, const Place& place) {
    for (const std::unique_ptr<SvgNode>& child : node.children)
        draw(*child, place);
}

void SvgDrawer::draw_use(const SvgNode& node, const SvgProperties& properties, Place place) {
    const std::string id = node.reference();
    if (id.empty())
        return;
    const SvgNode* target = styles_.find(id);
    if (target == nullptr)
        node.fail(fmt::format("use: refers to \"#{:.40}\", which is not in the file", id));
    for (const SvgNode* outer = &node; outer != nullptr; outer = outer->parent)
        if (outer == target)
            node.fail(fmt::format("use: refers to \"#{:.40}\", in which it stands", id));
    if (open_.size() >= deepest || std::find(open_.begin(), open_.end(), &node) != open_.end())
        node.fail(fmt::format("use: refers to \"#{:.40}\", which refers back to it", id));
    const Attribute attribute{[&](const std::string& name) { return properties.get(name, "0"); },
                              place.lengths()};
    Affine move;
    move.setTranslation(node.located(
        [&] { return Vec2(svg_length(attribute, "x", 0), svg_length(attribute, "y", 0)); }));
    place.pixel_from_user = move * place.pixel_from_user;
    // A clip is made of shapes only.
    if (place.purpose == Purpose::clip && !is_svg_shape(target->name) && target->name != "text")
        return;
    open_.push_back(&node);
    draw(*target, place, &properties);
    open_.pop_back();
}

void SvgDrawer::draw_shape(const SvgNode& node, const SvgProperties& properties,
                           const Place& place) {
    const SvgStyle& style = place.style;
    const bool wanted = place.purpose == Purpose::measure ||
                        (place.purpose == Purpose::clip ? style.visible : style.fills());
    const bool seen =
        place.purpose == Purpose::fill && style.visible && style.opacity > 0; // or its stroke is
    if (!wanted && !seen)
        return;
    if (wanted && place.purpose == Purpose::fill && !style.fill_unread.empty() &&
        node.name != "line")
        node.fail(node.name + ": " + style.fill_unread);
    BezierPath path;
    if (node.name != "line")
        path = node.located([&] {
            return svg_shape(node.name, {[&](const std::string& name) {
                                             return geometry_property(node, properties, name);
                                         },
                                         place.lengths()});
        });
    path.transform(place.pixel_from_user);
    const Box2 box = path.control_box();
    if (!box.isEmpty() && !(box.min.length() < largest && box.max.length() < largest))
        node.fail(node.name + ": its transforms make it too large");
    if (seen)
        note_left_out(node, properties, place, path);
    if (wanted && !box.isEmpty())
        out_->push_back({std::move(path),
                         place.purpose == Purpose::clip ? style.clip_rule : style.fill_rule,
                         place.within});
}

bool SvgDrawer::enter_viewport(const SvgNode& node, const SvgProperties& properties,
                               const SvgProperties* use, Place& place) {
    const SvgViewport viewport =
        node.located([&] { return svg_viewport(node, properties, place.lengths(), use); });
    const bool known = viewport.size.x > 0 && viewport.size.y > 0;
    const Box2 room(viewport.at, viewport.at + viewport.size);
    const std::string overflow = properties.keyword("overflow", "hidden");
    const bool cuts = overflow != "visible" && overflow != "auto";
    if (&node == &root_ && use == nullptr) {
        if (known && cuts && place.purpose == Purpose::fill)
            page_ = room;
    } else if (known && cuts && place.purpose != Purpose::measure) {
        BezierPath edge = rectangle_path(room);
        edge.transform(place.pixel_from_user);
        place.within.push_back(add_clip({{std::move(edge), FillRule::nonzero, {}}}));
    }
    place.viewport = viewport.inner;
    place.pixel_from_user = viewport.outer_from_inner * place.pixel_from_user;
    return viewport.drawn;
}

} // namespace scree
