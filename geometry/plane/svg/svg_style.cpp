// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/plane/svg/svg_style.h"

#include "core/text.h"
#include "geometry/plane/svg/css_color.h"
#include "geometry/plane/svg/svg_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace scree {

namespace {

constexpr int most_references = 20; // of variables or gradients to each other

FillRule rule_of(const std::string& name, const SvgProperties& properties, FillRule outer) {
    const std::optional<std::string> rule = properties.get(name, "nonzero");
    if (!rule)
        return outer;
    const std::string small = lower_case(*rule);
    if (small != "evenodd" && small != "nonzero")
        throw Error(fmt::format("{}: expected nonzero or evenodd, got \"{:.30}\"", name, *rule));
    return small == "evenodd" ? FillRule::evenodd : FillRule::nonzero;
}

double font_size_of(const SvgProperties& properties, double outer) {
    static constexpr std::array<std::pair<std::string_view, double>, 8> keywords{
        {{"xx-small", 9},
         {"x-small", 10},
         {"small", 13},
         {"medium", 16},
         {"large", 18},
         {"x-large", 24},
         {"xx-large", 32},
         {"xxx-large", 48}}};
    if (properties.css("font")) // a size among other things
        return std::nan("");
    const std::optional<std::string> size = properties.get("font-size", "medium");
    if (!size)
        return outer;
    const std::string small = lower_case(*size);
    for (const auto& [name, pixels] : keywords)
        if (small == name)
            return pixels;
    try {
        return parse_length(small, {.whole = outer, .font = outer});
    } catch (const Error&) {
        return std::nan(""); // told where a length needs it
    }
}

} // namespace

SvgProperties::SvgProperties(const SvgNode& node, CssProperties declared,
                             const CssProperties& custom)
    : node_(node), declared_(std::move(declared)), custom_(custom) {
    for (const auto& [name, value] : declared_)
        if (name.starts_with("--"))
            custom_[name] = value;
}

std::optional<std::string> SvgProperties::css(const std::string& name) const {
    const auto found = declared_.find(name);
    if (found == declared_.end())
        return {};
    return resolved(name, found->second);
}

std::optional<std::string> SvgProperties::get(const std::string& name,
                                              const std::string& initial) const {
    std::optional<std::string> value = css(name);
    if (!value) {
        const std::string* attribute = node_.attribute(name);
        if (attribute == nullptr || trimmed(*attribute).empty())
            return {};
        value = resolved(name, std::string(trimmed(*attribute)));
    }
    const std::string small = lower_case(*value);
    if (small == "inherit" || small == "unset" || small == "revert" || small == "revert-layer")
        return {};
    return small == "initial" ? initial : value;
}

std::string SvgProperties::keyword(const std::string& name, const std::string& initial) const {
    return lower_case(get(name, initial).value_or(initial));
}

/// CSS Custom Properties 1, section 3.
std::string SvgProperties::resolved(const std::string& name, std::string value, int depth) const {
    const std::size_t at = lower_case(value).find("var(");
    if (at == std::string::npos) {
        if (value.find('&') != std::string::npos)
            throw Error(fmt::format("{}: \"{:.40}\" refers to an entity, which is not read; save "
                                    "it as plain SVG",
                                    name, value));
        return value;
    }
    const std::string_view inside = std::string_view(value).substr(at + 4);
    const std::size_t close = css_split(inside, ')').front().size();
    if (depth > most_references || close == inside.size())
        throw Error(fmt::format("{}: \"{:.40}\" is not read", name, value));
    const std::vector<std::string_view> parts = css_split(inside.substr(0, close), ',');
    const auto known = custom_.find(std::string(trimmed(parts.front())));
    if (known == custom_.end() && parts.size() < 2)
        throw Error(fmt::format("{}: {} is not declared", name, trimmed(parts.front())));
    const std::string put = known != custom_.end()
                                ? known->second
                                : std::string(inside.substr(parts.front().size() + 1,
                                                            close - parts.front().size() - 1));
    return resolved(
        name, std::string(trimmed(value.substr(0, at) + put + value.substr(at + 4 + close + 1))),
        depth + 1);
}

SvgStyles::SvgStyles(const SvgNode& root) {
    for_each_node(root, [&](const SvgNode& node) {
        if (const std::string* id = node.attribute("id")) {
            by_id_.try_emplace(*id, &node);
            ids_.push_back(*id);
        }
        if (node.name != "style")
            return;
        const std::string* type = node.attribute("type");
        if (type != nullptr && !type->empty() && lower_case(trimmed(*type)) != "text/css")
            node.fail(fmt::format("style: its type is \"{:.30}\", expected text/css", *type));
        const std::string* media = node.attribute("media");
        node.located([&] {
            sheet_.add(media == nullptr ? node.text : "@media " + *media + " {" + node.text + "}");
            return 0;
        });
    });
}

const SvgNode* SvgStyles::find(const std::string& id) const {
    const auto found = by_id_.find(id);
    return found == by_id_.end() ? nullptr : found->second;
}

std::vector<std::string> SvgStyles::ids() const { return ids_; }

SvgProperties SvgStyles::properties(const SvgNode& node, const SvgStyle& outer) const {
    return node.located([&] { return SvgProperties(node, sheet_.declared(node), outer.custom); });
}

SvgStyle SvgStyles::computed(const SvgNode& node, const SvgProperties& properties,
                             const SvgStyle& outer) const {
    return node.located([&] {
        SvgStyle style = outer;
        style.custom = properties.custom();
        style.font_size = font_size_of(properties, outer.font_size);
        const auto opacity = [&](const std::string& name, double otherwise) {
            const auto value = properties.get(name, "1");
            return value ? named(name, [&] { return css_opacity(*value); }) : otherwise;
        };
        if (const auto color = properties.get("color", "black"))
            style.color_alpha =
                named("color", [&] { return css_alpha(*color).value_or(outer.color_alpha); });
        if (const auto fill = properties.get("fill", "black")) {
            // Told where something is filled with it.
            Paint read;
            style.fill_unread.clear();
            try {
                read = paint(*fill);
            } catch (const Error& error) {
                style.fill_unread = "fill: " + error.diagnostics().front().message;
            }
            style.fill_alpha = read.alpha;
            style.fill_current = read.current;
        }
        style.fill_opacity = opacity("fill-opacity", outer.fill_opacity);
        style.opacity = outer.opacity * opacity("opacity", 1);
        style.fill_rule = rule_of("fill-rule", properties, outer.fill_rule);
        style.clip_rule = rule_of("clip-rule", properties, outer.clip_rule);
        if (const auto visibility = properties.get("visibility", "visible"))
            style.visible = lower_case(*visibility) == "visible";
        if (const auto stroke = properties.get("stroke", "none"))
            style.stroked = lower_case(*stroke) != "none" && lower_case(*stroke) != "transparent";
        if (properties.keyword("stroke-width", "1") == "0" || opacity("stroke-opacity", 1) == 0)
            style.stroked = false;
        return style;
    });
}

SvgStyles::Paint SvgStyles::paint(const std::string& value) const {
    const std::string small = lower_case(value);
    if (small == "none")
        return {0, false};
    if (!small.starts_with("url(")) {
        const std::optional<double> alpha = css_alpha(value);
        return {alpha.value_or(1), !alpha};
    }
    const std::size_t close = std::min(value.find(')'), value.size());
    std::string_view target = trimmed(std::string_view(value).substr(4, close - 4));
    if (target.size() >= 2 && (target.front() == '"' || target.front() == '\''))
        target = trimmed(target.substr(1, target.size() - 2));
    const std::string fallback(
        trimmed(std::string_view(value).substr(std::min(close + 1, value.size()))));
    const SvgNode* server = target.starts_with('#') ? find(std::string(target.substr(1))) : nullptr;
    if (server == nullptr && !fallback.empty())
        return paint(fallback);
    if (server == nullptr)
        throw Error(fmt::format("refers to \"{:.40}\", which is not in the file", target));
    if (server->name != "linearGradient" && server->name != "radialGradient")
        throw Error(fmt::format("is a {} ({:.40}), which is not read", server->name, target));
    return {gradient_alpha(*server, 0), false};
}

/// The greatest alpha of its stops, or of those of the gradient that it refers to.
double SvgStyles::gradient_alpha(const SvgNode& gradient, int depth) const {
    double most = 0;
    bool stops = false;
    for (const std::unique_ptr<SvgNode>& child : gradient.children) {
        if (child->name != "stop")
            continue;
        stops = true;
        const SvgProperties of_stop = properties(*child, {});
        const double alpha = child->located([&] {
            const double opacity = css_opacity(of_stop.get("stop-opacity", "1").value_or("1"));
            const auto color = css_alpha(of_stop.get("stop-color", "black").value_or("black"));
            return opacity * (color ? *color : color_of(*child));
        });
        most = std::max(most, alpha);
    }
    const std::string other = stops ? std::string() : gradient.reference();
    if (other.empty())
        return most;
    const SvgNode* next = find(other);
    if (next == nullptr || depth > most_references)
        gradient.fail(fmt::format("{}: refers to \"#{:.40}\", which is {}", gradient.name, other,
                                  next == nullptr ? "not in the file" : "a ring of references"));
    return gradient_alpha(*next, depth + 1);
}

/// The alpha of `color` where it is declared, from the element outwards.
double SvgStyles::color_of(const SvgNode& node) const {
    for (const SvgNode* at = &node; at != nullptr; at = at->parent)
        if (const auto color = properties(*at, {}).get("color", "black"))
            if (const std::optional<double> alpha = css_alpha(*color))
                return *alpha;
    return 1;
}

} // namespace scree
