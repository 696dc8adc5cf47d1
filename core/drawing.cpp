// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drawing.h"

#include "core/drawing_raster.h"
#include "core/drawing_style.h"
#include "core/embedded_picture.h"
#include "core/error.h"
#include "core/text.h"

#include <fmt/format.h>
#include <pugixml.hpp>

#include <algorithm>
#include <map>
#include <sstream>

namespace scree {

namespace {

constexpr int max_depth = 200; // usual drawings have less than 20
constexpr std::uint64_t max_drawn = 200'000;
constexpr int max_chain = 1000; // of elements and clones, one in the other

// White space within text elements is significant.
constexpr unsigned parsing = pugi::parse_default | pugi::parse_ws_pcdata;

std::string_view local_name(std::string_view name) { return name.substr(name.find(':') + 1); }

bool is_reference(std::string_view attribute) {
    return local_name(attribute) == "href" || local_name(attribute) == "src";
}

bool is_element(const pugi::xml_node& node) { return node.type() == pugi::node_element; }

std::string style_text(const pugi::xml_node& style) {
    std::string text;
    for (const pugi::xml_node& child : style.children())
        text += child.value();
    return text;
}

std::string serialized(const pugi::xml_node& root) {
    std::ostringstream out;
    root.print(out, "", pugi::format_raw);
    return out.str();
}

/// Calls `visit` for every element, parents first.
template <class Visit>
void for_each_element(pugi::xml_node root, const Visit& visit) {
    struct Walker : pugi::xml_tree_walker {
        const Visit* visit = nullptr;
        bool for_each(pugi::xml_node& node) override {
            if (is_element(node))
                (*visit)(node, depth());
            return true;
        }
    } walker;
    walker.visit = &visit;
    visit(root, 0);
    root.traverse(walker);
}

/// How many elements are drawn when every `use` is replaced by what it refers to.
class DrawnElements {
  public:
    explicit DrawnElements(const pugi::xml_node& root) {
        for_each_element(root, [&](const pugi::xml_node& node, int) {
            if (const char* id = node.attribute("id").value(); *id != '\0')
                by_id_.emplace(id, node);
        });
    }

    /// `max_drawn` for as many or more, and where clones of clones are nested too deep.
    std::uint64_t count(const pugi::xml_node& node, int depth = 0) {
        if (depth > max_chain)
            return max_drawn;
        std::uint64_t sum = 1;
        if (local_name(node.name()) == "use")
            for (const pugi::xml_attribute& attribute : node.attributes())
                if (is_reference(attribute.name()))
                    sum += count_of(std::string(trimmed(attribute.value())), depth);
        for (const pugi::xml_node& child : node.children())
            if (is_element(child) && sum < max_drawn && local_name(child.name()) != "defs" &&
                local_name(child.name()) != "symbol")
                sum += count(child, depth + 1);
        return std::min(sum, max_drawn);
    }

  private:
    std::uint64_t count_of(const std::string& reference, int depth) {
        const auto target =
            by_id_.find(reference.substr(std::min<std::size_t>(1, reference.size())));
        if (target == by_id_.end())
            return 0;
        const auto [known, is_new] = counts_.try_emplace(target->first, 0); // 0: in a circle
        if (is_new)
            known->second = count(target->second, depth + 1);
        return known->second;
    }

    std::map<std::string, pugi::xml_node> by_id_;
    std::map<std::string, std::uint64_t> counts_;
};

class Checker {
  public:
    explicit Checker(const std::string& bytes) : bytes_(bytes) {
        const pugi::xml_parse_result result =
            document_.load_buffer(bytes.data(), bytes.size(), parsing | pugi::parse_doctype);
        if (!result)
            throw Error(fmt::format("line {}: {}", line_of(result.offset), result.description()));
        for (const pugi::xml_node& node : document_.children())
            if (node.type() == pugi::node_doctype &&
                std::string_view(node.value()).find('[') != std::string_view::npos)
                fail(node, "declares entities, which are not read; save it as plain SVG");
        if (local_name(root().name()) != "svg")
            fail(root(),
                 fmt::format("the file's element is \"{:.30}\", expected svg", root().name()));
        for_each_element(root(), [&](const pugi::xml_node& node, int depth) {
            if (depth > max_depth)
                fail(node, fmt::format("elements are nested more than {} deep", max_depth));
            check(node);
        });
        if (DrawnElements(root()).count(root()) >= max_drawn)
            fail(root(), fmt::format("more than {} elements are drawn, with clones", max_drawn));
    }

    pugi::xml_node root() const { return document_.document_element(); }

  private:
    [[noreturn]] void fail(const pugi::xml_node& node, const std::string& message) const {
        throw Error(fmt::format("line {}: {}", line_of(node.offset_debug()), message));
    }

    std::size_t line_of(std::ptrdiff_t offset) const {
        const std::size_t end =
            std::min(bytes_.size(), std::size_t(std::max<std::ptrdiff_t>(0, offset)));
        return 1 + std::size_t(std::count(bytes_.begin(),
                                          bytes_.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
    }

    void check(const pugi::xml_node& node) const {
        static const std::string_view refused[] = {"script",   "foreignObject", "handler",
                                                   "listener", "iframe",        "object",
                                                   "embed",    "audio",         "video"};
        const std::string_view name = local_name(node.name());
        if (std::find(std::begin(refused), std::end(refused), name) != std::end(refused))
            fail(node, fmt::format("holds an element \"{}\"; only what is drawn is taken", name));
        for (const pugi::xml_attribute& attribute : node.attributes())
            check(node, name, attribute);
        if (name == "style") {
            try {
                check_style(style_text(node));
            } catch (const Error& error) {
                fail(node, "style: " + error.diagnostics().front().message);
            }
        }
    }

    void check(const pugi::xml_node& node, std::string_view element,
               const pugi::xml_attribute& attribute) const {
        const std::string_view name = attribute.name();
        const std::string_view value = attribute.value();
        const auto refuse = [&](const std::string& why) {
            fail(node, fmt::format("{}: {}: {}", element, name, why));
        };
        if (name.starts_with("on"))
            refuse("is a script; only what is drawn is taken");
        if (element == "a" && is_reference(name))
            return; // a link, which `read_drawing` leaves out
        if (is_reference(name) && !is_inside(value))
            refuse(fmt::format("refers to \"{:.60}\", outside the file; embed it", value));
        if (is_reference(name) && lower_case(trimmed(value).substr(0, 5)) == "data:") {
            try {
                check_embedded_picture(value);
            } catch (const Error& error) {
                refuse(error.diagnostics().front().message);
            }
        }
        if (name == "attributeName" && is_reference(value))
            refuse("animates a reference");
        if (name.find(':') != std::string_view::npos)
            return; // private data of drawing programs
        if (const std::string outside = outside_reference(value); !outside.empty())
            refuse(fmt::format("refers to \"{:.60}\", outside the file; embed it", outside));
    }

    const std::string& bytes_;
    pugi::xml_document document_;
};

// Private data of drawing programs, which is not drawn.
bool is_metadata(const pugi::xml_node& node) {
    const std::string_view name = node.name();
    return local_name(name) == "metadata" || name.starts_with("sodipodi:");
}

void remove_metadata(pugi::xml_node node) {
    for (pugi::xml_node child = node.first_child(); child;) {
        const pugi::xml_node next = child.next_sibling();
        if (is_element(child) && is_metadata(child))
            node.remove_child(child);
        child = next;
    }
}

void set_attribute(pugi::xml_node node, const char* name, const std::string& value) {
    node.remove_attribute(name);
    node.append_attribute(name).set_value(value.c_str());
}

void rename(pugi::xml_node node, const std::string& prefix, const std::string& scope) {
    for (pugi::xml_attribute attribute : node.attributes()) {
        const std::string value = attribute.value();
        if (local_name(attribute.name()) == "id")
            attribute.set_value((prefix + value).c_str());
        else if (is_reference(attribute.name()) && value.starts_with('#'))
            attribute.set_value(("#" + prefix + value.substr(1)).c_str());
        else if (value.find("url(") != std::string::npos)
            attribute.set_value(with_prefix(value, prefix).c_str());
    }
    if (local_name(node.name()) == "style") {
        const std::string text = scoped_style(style_text(node), prefix, scope);
        node.remove_children();
        node.append_child(pugi::node_pcdata).set_value(text.c_str());
    }
}

} // namespace

Drawing read_drawing(const std::string& bytes) {
    const Checker checked(bytes);
    pugi::xml_document document;
    pugi::xml_node root = document.append_copy(checked.root());
    remove_metadata(root);
    for_each_element(root, [](pugi::xml_node node, int) {
        node.remove_attribute("xml:base");
        if (local_name(node.name()) == "a")
            for (const char* link : {"href", "xlink:href"})
                node.remove_attribute(link);
    });
    const Vec2 size = drawing_size(serialized(root));
    if (!root.attribute("viewBox")) {
        set_attribute(root, "viewBox", fmt::format("0 0 {:.9g} {:.9g}", size.x, size.y));
        set_attribute(root, "preserveAspectRatio", "none");
    }
    for (const char* attribute : {"x", "y", "width", "height"})
        root.remove_attribute(attribute);
    return {serialized(root), size};
}

std::string embedded_drawing(const std::string& markup, const std::string& prefix,
                             const std::string& scope, const Box2& place) {
    pugi::xml_document document;
    if (!document.load_buffer(markup.data(), markup.size(), parsing))
        throw std::logic_error("the drawing was not read by read_drawing");
    pugi::xml_node root = document.document_element();
    for_each_element(root, [&](const pugi::xml_node& node, int) { rename(node, prefix, scope); });
    const Vec2 size = place.size();
    set_attribute(root, "x", fmt::format("{:.9g}", place.min.x));
    set_attribute(root, "y", fmt::format("{:.9g}", place.min.y));
    set_attribute(root, "width", fmt::format("{:.9g}", size.x));
    set_attribute(root, "height", fmt::format("{:.9g}", size.y));
    return serialized(root);
}

} // namespace scree
