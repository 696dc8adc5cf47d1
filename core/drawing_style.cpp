// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drawing_style.h"

#include "core/error.h"
#include "core/text.h"

#include <algorithm>
#include <cctype>

namespace scree {

namespace {

constexpr auto npos = std::string_view::npos;

std::string_view unquoted(std::string_view text) {
    text = trimmed(text);
    if (text.size() >= 2 && (text.front() == '"' || text.front() == '\'') &&
        text.back() == text.front())
        text = text.substr(1, text.size() - 2);
    return trimmed(text);
}

bool is_name(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_' ||
           static_cast<unsigned char>(c) >= 0x80;
}

std::string scoped_selector(std::string_view selector, std::string_view prefix,
                            std::string_view scope) {
    std::string out = "#" + std::string(scope) + " ";
    for (std::size_t i = 0; i < selector.size(); ++i) {
        out += selector[i];
        if (selector[i] == '#' && i + 1 < selector.size() && is_name(selector[i + 1]))
            out += prefix;
    }
    return out;
}

} // namespace

std::string without_comments(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        const std::size_t begin = text.find("/*");
        out += text.substr(0, begin);
        if (begin == npos)
            break;
        const std::size_t end = text.find("*/", begin + 2);
        text = end == npos ? std::string_view() : text.substr(end + 2);
        out += ' ';
    }
    // Style sheets used to be wrapped in these to hide them from old browsers.
    for (const char* mark : {"<!--", "-->"})
        for (std::size_t at = out.find(mark); at != std::string::npos; at = out.find(mark))
            out.erase(at, std::string_view(mark).size());
    return out;
}

bool is_inside(std::string_view reference) {
    const std::string start = lower_case(trimmed(reference).substr(0, 32));
    return start.empty() || start.starts_with('#') || start.starts_with("data:image/png;") ||
           start.starts_with("data:image/jpeg;") || start.starts_with("data:image/jpg;");
}

std::string outside_reference(std::string_view value) {
    if (value.find('(') == npos)
        return {};
    if (value.find('\\') != npos)
        return std::string(trimmed(value));
    const std::string small = lower_case(without_comments(value));
    for (const char* function : {"image-set(", "image(", "src("})
        if (const std::size_t at = small.find(function); at != std::string::npos)
            return small.substr(at);
    for (std::size_t at = small.find("url("); at != std::string::npos;
         at = small.find("url(", at)) {
        at += 4;
        const std::size_t end = std::min(small.find(')', at), small.size());
        const std::string_view target = unquoted(std::string_view(small).substr(at, end - at));
        if (!is_inside(target))
            return std::string(target);
    }
    return {};
}

void check_style(std::string_view sheet) {
    const std::string text = without_comments(sheet);
    if (const std::size_t at = text.find('@'); at != std::string::npos)
        throw Error("the rule \"" + text.substr(at, 20) + "\" is not read; take it out");
    if (text.find('\\') != std::string::npos)
        throw Error("escapes with \\ are not read");
    if (const std::string outside = outside_reference(text); !outside.empty())
        throw Error("refers to \"" + outside.substr(0, 60) + "\", outside the file; embed it");
}

std::string with_prefix(std::string_view value, std::string_view prefix) {
    std::string out;
    while (!value.empty()) {
        std::size_t at = value.find("url(");
        if (at == npos)
            break;
        at = value.find_first_not_of(" \t\r\n'\"", at + 4);
        if (at == npos)
            break;
        out += value.substr(0, at);
        value.remove_prefix(at);
        if (value.front() == '#') {
            out += '#';
            out += prefix;
            value.remove_prefix(1);
        }
    }
    return out.append(value);
}

std::string scoped_style(std::string_view sheet, std::string_view prefix, std::string_view scope) {
    const std::string text = without_comments(sheet);
    std::string_view rest = text;
    std::string out;
    while (true) {
        const std::size_t open = rest.find('{');
        if (open == npos)
            return out;
        const std::size_t close = std::min(rest.find('}', open), rest.size());
        std::string_view selectors = rest.substr(0, open);
        std::string list;
        while (!selectors.empty()) {
            const std::size_t comma = std::min(selectors.find(','), selectors.size());
            list += (list.empty() ? "" : ",") +
                    scoped_selector(trimmed(selectors.substr(0, comma)), prefix, scope);
            selectors.remove_prefix(std::min(comma + 1, selectors.size()));
        }
        out += list + with_prefix(rest.substr(open, close - open), prefix) + "}";
        rest.remove_prefix(std::min(close + 1, rest.size()));
    }
}

} // namespace scree
