// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/plane/svg/css_sheet.h"

#include "core/drawing_style.h"
#include "core/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <tuple>

namespace scree {

namespace {

/// Where `c` first stands outside brackets and quotes; the size when it does not.
std::size_t find_outside(std::string_view text, char c) {
    int depth = 0;
    char quote = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (quote != 0) {
            quote = text[i] == quote ? '\0' : quote;
        } else if (depth == 0 && text[i] == c) {
            return i;
        } else if (text[i] == '"' || text[i] == '\'') {
            quote = text[i];
        } else if (text[i] == '(' || text[i] == '[' || text[i] == '{') {
            ++depth;
        } else if (text[i] == ')' || text[i] == ']' || text[i] == '}') {
            depth = std::max(0, depth - 1);
        }
    }
    return text.size();
}

/// Whether a media query holds on a screen that is light.
bool is_for_screens(std::string_view queries) {
    static constexpr std::array<std::string_view, 5> shown{"", "all", "screen", "onlyscreen",
                                                           "(prefers-color-scheme:light)"};
    static constexpr std::array<std::string_view, 6> hidden{
        "print", "onlyprint", "speech", "notall", "notscreen", "(prefers-color-scheme:dark)"};
    const auto is_in = [](const auto& list, const std::string& query) {
        return std::find(list.begin(), list.end(), query) != list.end();
    };
    for (const std::string_view query : css_split(queries, ',')) {
        std::string small = lower_case(query);
        std::erase_if(small, [](char c) { return c == ' ' || (c >= '\t' && c <= '\r'); });
        if (is_in(shown, small))
            return true;
        if (!is_in(hidden, small))
            throw Error(
                fmt::format("the rule \"@media {:.40}\" is not read; take it out", trimmed(query)));
    }
    return false;
}

} // namespace

std::vector<std::string_view> css_split(std::string_view text, char separator) {
    std::vector<std::string_view> parts;
    while (true) {
        const std::size_t end = find_outside(text, separator);
        parts.push_back(text.substr(0, end));
        if (end == text.size())
            return parts;
        text.remove_prefix(end + 1);
    }
}

void CssSheet::add(std::string_view text) {
    const std::string plain = without_comments(text);
    if (plain.find('\\') != std::string::npos)
        throw Error("escapes with \\ are not read");
    add_rules(plain);
}

void CssSheet::add_rules(std::string_view text) {
    for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
        const bool at_rule = text.front() == '@';
        const std::size_t open = find_outside(text, '{');
        const std::size_t end = at_rule ? std::min(open, find_outside(text, ';')) : open;
        if (!at_rule && end == text.size())
            throw Error(fmt::format("expected {{ after \"{:.40}\"", text));
        std::string_view block;
        std::size_t after = std::min(end + 1, text.size());
        if (end == open && end < text.size()) {
            const std::size_t close = find_outside(text.substr(after), '}');
            block = text.substr(after, close);
            after = std::min(after + close + 1, text.size());
        }
        const std::string_view prelude = trimmed(text.substr(0, end));
        if (at_rule) {
            const std::size_t name = std::min(prelude.find_first_of(" \t\r\n\f("), prelude.size());
            add_at_rule(prelude.substr(0, name), trimmed(prelude.substr(name)), block);
        } else {
            if (block.find('{') != std::string_view::npos)
                throw Error(fmt::format("the rules inside \"{:.40}\" are not read", prelude));
            for (const std::string_view selector : css_split(prelude, ','))
                rules_.push_back({CssSelector(selector), blocks_.size()});
            blocks_.push_back(declarations(block));
        }
        text.remove_prefix(after);
    }
}

void CssSheet::add_at_rule(std::string_view name, std::string_view prelude,
                           std::string_view block) {
    static constexpr std::array<std::string_view, 6> draw_nothing{
        "@font-face", "@page", "@keyframes", "@-webkit-keyframes", "@charset", "@namespace"};
    const std::string small = lower_case(name);
    if (small == "@media") {
        if (is_for_screens(prelude))
            add_rules(block);
    } else if (std::find(draw_nothing.begin(), draw_nothing.end(), small) == draw_nothing.end()) {
        throw Error(fmt::format("the rule \"{:.20}\" is not read; take it out", name));
    }
}

std::vector<CssSheet::Declaration> CssSheet::declarations(std::string_view block) {
    std::vector<Declaration> out;
    for (const std::string_view entry : css_split(block, ';')) {
        if (trimmed(entry).empty())
            continue;
        const std::size_t colon = std::min(entry.find(':'), entry.size());
        const std::string_view name = trimmed(entry.substr(0, colon));
        if (colon == entry.size() || name.empty())
            throw Error(
                fmt::format("expected a property and its value, got \"{:.40}\"", trimmed(entry)));
        Declaration declared{name.starts_with("--") ? std::string(name) : lower_case(name),
                             std::string(trimmed(entry.substr(colon + 1))), false};
        if (const std::size_t mark = find_outside(declared.value, '!');
            mark < declared.value.size()) {
            if (lower_case(trimmed(std::string_view(declared.value).substr(mark + 1))) !=
                "important")
                throw Error(fmt::format("{}: \"{:.40}\" is not read", name, declared.value));
            declared.value = std::string(trimmed(std::string_view(declared.value).substr(0, mark)));
            declared.important = true;
        }
        out.push_back(std::move(declared));
    }
    return out;
}

CssProperties CssSheet::declared(const SvgNode& node) const {
    struct Ranked {
        bool important;
        bool own; // in the attribute `style`
        Specificity specificity;
        const Declaration* declaration;
    };
    std::vector<Declaration> own;
    if (const std::string* style = node.attribute("style")) {
        const std::string plain = without_comments(*style);
        if (plain.find('\\') != std::string::npos)
            throw Error("style: escapes with \\ are not read");
        own = declarations(plain);
    }
    std::vector<Ranked> all;
    for (const Rule& rule : rules_)
        if (rule.selector.matches(node))
            for (const Declaration& d : blocks_[rule.block])
                all.push_back({d.important, false, rule.selector.specificity(), &d});
    for (const Declaration& d : own)
        all.push_back({d.important, true, {}, &d});
    std::stable_sort(all.begin(), all.end(), [](const Ranked& a, const Ranked& b) {
        return std::tie(a.important, a.own, a.specificity) <
               std::tie(b.important, b.own, b.specificity);
    });
    CssProperties out;
    for (const Ranked& ranked : all)
        out[ranked.declaration->name] = ranked.declaration->value;
    return out;
}

} // namespace scree
