// SPDX-License-Identifier: GPL-3.0-or-later
// The only file that uses pugixml.
#include "geometry/plane/svg/svg_document.h"

#include "core/error.h"
#include "core/file.h"
#include "geometry/plane/svg/svg_shapes.h"
#include "geometry/plane/svg/svg_text.h"

#include <fmt/format.h>
#include <pugixml.hpp>

#include <algorithm>
#include <array>

namespace scree {

namespace {

constexpr std::uint64_t largest_file = std::uint64_t{64} << 20;
constexpr int deepest = 200; // drawings stay below 20

using Names = std::vector<std::string>;

// Groups, whose children are drawn.
const Names groups{"svg", "g", "a", "switch"};
// What draws nothing by itself, and a line, which has no inside.
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
                    "line",
                    "font",
                    "animate",
                    "set",
                    "cursor",
                    "meshgradient",
                    "animateTransform",
                    "animateMotion",
                    "solidcolor",
                    "hatch"};
// What has an area that is not read.
const Names unread{"text", "use", "image", "foreignObject"};

bool is_one_of(const std::string& name, const Names& names) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

/// What an element inherits.
struct Context {
    Affine pixel_from_user;
    FillRule rule = FillRule::nonzero;
    bool filled = true;
    bool visible = true;
    Vec2 viewport{0.0}; // size of the nearest svg's own units; 0: not known
};

std::string trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos)
        return {};
    return std::string(text.substr(begin, text.find_last_not_of(" \t\r\n") - begin + 1));
}

/// A property from `style`, which goes before the attribute of the same name.
std::string property(const pugi::xml_node& node, const char* name) {
    std::string value = trimmed(node.attribute(name).value());
    std::string_view style = node.attribute("style").value();
    while (!style.empty()) {
        const std::size_t end = std::min(style.find(';'), style.size());
        const std::string_view entry = style.substr(0, end);
        const std::size_t colon = entry.find(':');
        if (colon != std::string_view::npos && trimmed(entry.substr(0, colon)) == name)
            value = trimmed(entry.substr(colon + 1));
        style.remove_prefix(std::min(end + 1, style.size()));
    }
    return value;
}

/// Without the prefix that some programs write: svg:path. Names of other spaces keep theirs.
std::string plain_name(const pugi::xml_node& node) {
    const std::string name = node.name();
    return name.starts_with("svg:") ? name.substr(4) : name;
}

class Document {
  public:
    explicit Document(const std::string& bytes) : bytes_(bytes) {
        const pugi::xml_parse_result result = document_.load_buffer(bytes.data(), bytes.size());
        if (!result)
            throw Error(fmt::format("line {}: {}", line_of(result.offset), result.description()));
        if (plain_name(root()) != "svg")
            fail(root(), fmt::format("the file's element is \"{}\", expected svg",
                                     plain_name(root()).substr(0, 30)));
    }

    std::vector<SvgShape> shapes(const std::string& id) {
        if (id.empty()) {
            draw(root(), {}, 0);
            return std::move(shapes_);
        }
        const pugi::xml_node chosen = document_.find_node(
            [&](const pugi::xml_node& node) { return id == node.attribute("id").value(); });
        if (!chosen)
            throw Error(Diagnostic{
                {}, {}, fmt::format("no element has the id \"{}\"", id), did_you_mean(id, ids())});
        std::vector<pugi::xml_node> ancestors;
        for (pugi::xml_node node = chosen.parent(); node && node != document_; node = node.parent())
            ancestors.push_back(node);
        Context context;
        for (auto node = ancestors.rbegin(); node != ancestors.rend(); ++node)
            context = inside(*node, context);
        context.visible = true; // asked for by name, even in defs
        draw(chosen, context, 0);
        return std::move(shapes_);
    }

  private:
    pugi::xml_node root() const { return document_.document_element(); }

    std::size_t line_of(std::ptrdiff_t offset) const {
        const std::size_t end =
            std::min(bytes_.size(), std::size_t(std::max<std::ptrdiff_t>(0, offset)));
        return 1 + std::size_t(std::count(bytes_.begin(),
                                          bytes_.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
    }

    [[noreturn]] void fail(const pugi::xml_node& node, const std::string& message) const {
        throw Error(fmt::format("line {}: {}", line_of(node.offset_debug()), message));
    }

    /// What `read` throws, with the element's line and name.
    template <class Read>
    auto located(const pugi::xml_node& node, const Read& read) const {
        try {
            return read();
        } catch (const Error& error) {
            fail(node, plain_name(node) + ": " + error.diagnostics().front().message);
        }
    }

    std::vector<std::string> ids() {
        std::vector<std::string> out;
        document_.find_node([&](const pugi::xml_node& node) {
            if (const pugi::xml_attribute id = node.attribute("id"))
                out.emplace_back(id.value());
            return false;
        });
        return out;
    }

    static Attribute attributes(const pugi::xml_node& node) {
        return [node](const std::string& name) -> std::optional<std::string> {
            const pugi::xml_attribute attribute = node.attribute(name.c_str());
            return attribute ? std::optional<std::string>(attribute.value()) : std::nullopt;
        };
    }

    /// What a group's children inherit.
    Context inside(const pugi::xml_node& node, Context context) const {
        if (const pugi::xml_attribute transform = node.attribute("transform"))
            context.pixel_from_user =
                located(node, [&] { return parse_transform(transform.value()); }) *
                context.pixel_from_user;
        if (plain_name(node) == "svg")
            located(node, [&] {
                enter_viewport(node, context);
                return 0;
            });
        const std::string rule = property(node, "fill-rule");
        if (rule == "evenodd" || rule == "nonzero")
            context.rule = rule == "evenodd" ? FillRule::evenodd : FillRule::nonzero;
        const std::string fill = property(node, "fill");
        if (!fill.empty() && fill != "inherit")
            context.filled = fill != "none" && fill != "transparent";
        const std::string visibility = property(node, "visibility");
        if (!visibility.empty() && visibility != "inherit")
            context.visible = visibility == "visible";
        return context;
    }

    /// A width or height of an svg; 0 when not given or a share of what is not known.
    static double side(const pugi::xml_node& node, const char* name, double outer) {
        const std::string text = trimmed(node.attribute(name).value());
        if (text.empty() || text == "auto" || text == "100%")
            return outer;
        const double length = parse_length(text);
        if (length < 0)
            throw Error(fmt::format("{}: is negative: {}", name, text));
        return length;
    }

    /// SVG 1.1, section 7.7 to 7.9: the viewBox is fitted into x, y, width and height.
    void enter_viewport(const pugi::xml_node& node, Context& context) const {
        const bool outermost = node == root();
        const Attribute attribute = attributes(node);
        Vec2 at(0.0);
        if (!outermost)
            at = {svg_length(attribute, "x", 0), svg_length(attribute, "y", 0)};
        const Vec2 outer = outermost ? Vec2(0.0) : context.viewport;
        Vec2 size(side(node, "width", outer.x), side(node, "height", outer.y));
        context.viewport = size;
        Affine fit;
        if (const pugi::xml_attribute box = node.attribute("viewBox")) {
            const std::vector<double> numbers = parse_numbers(box.value());
            if (numbers.size() != 4 || !(numbers[2] > 0) || !(numbers[3] > 0))
                throw Error(fmt::format("viewBox: expected x, y, and a width and height above 0, "
                                        "got \"{:.40}\"",
                                        box.value()));
            const Vec2 user(numbers[2], numbers[3]);
            // One side given alone keeps the box's proportions, none its size.
            if (size.x == 0)
                size.x = size.y == 0 ? user.x : size.y * user.x / user.y;
            if (size.y == 0)
                size.y = size.x * user.y / user.x;
            fit = fitted({numbers[0], numbers[1]}, user, size,
                         trimmed(node.attribute("preserveAspectRatio").value()));
            context.viewport = user;
        }
        Affine move;
        move.setTranslation(at);
        context.pixel_from_user = fit * move * context.pixel_from_user;
    }

    static Affine fitted(const Vec2& origin, const Vec2& user, const Vec2& size,
                         const std::string& aspect) {
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

    void draw(const pugi::xml_node& node, const Context& outer, int depth) {
        if (depth > deepest)
            fail(node, fmt::format("elements are nested more than {} deep", deepest));
        const std::string name = plain_name(node);
        if (is_one_of(name, undrawn) && depth > 0)
            return;
        if (property(node, "display") == "none")
            return;
        const bool group = is_one_of(name, groups) || (depth == 0 && is_one_of(name, undrawn));
        const Context context = inside(node, outer);
        if (group) {
            for (const pugi::xml_node& child : node.children())
                // Elements of other spaces (sodipodi:namedview) are not the drawing's.
                if (child.type() == pugi::node_element &&
                    plain_name(child).find(':') == std::string::npos)
                    draw(child, context, depth + 1);
        } else if (is_svg_shape(name)) {
            if (context.filled && context.visible)
                add_shape(node, name, context);
        } else if (is_one_of(name, unread)) {
            fail(node, fmt::format("{} is not read; convert it to a path", name));
        } else {
            fail(node, fmt::format("unknown element \"{}\"", name.substr(0, 30)));
        }
    }

    void add_shape(const pugi::xml_node& node, const std::string& name, const Context& context) {
        BezierPath path = located(node, [&] { return svg_shape(name, attributes(node)); });
        path.transform(context.pixel_from_user);
        const Box2 box = path.control_box();
        if (!box.isEmpty() && !(box.min.length() < 1e15 && box.max.length() < 1e15))
            fail(node, name + ": its transforms make it too large");
        if (!box.isEmpty())
            shapes_.push_back({std::move(path), context.rule});
    }

    const std::string& bytes_;
    pugi::xml_document document_;
    std::vector<SvgShape> shapes_;
};

} // namespace

std::vector<SvgShape> read_svg_text(const std::string& bytes, const std::string& element) {
    return Document(bytes).shapes(element);
}

std::vector<SvgShape> read_svg(const std::string& path, const std::string& element) {
    const std::string bytes = read_file(path, largest_file);
    try {
        return read_svg_text(bytes, element);
    } catch (const Error& error) {
        const Diagnostic& first = error.diagnostics().front();
        throw Error(Diagnostic{{}, {}, path + ": " + first.message, first.hint});
    }
}

} // namespace scree
