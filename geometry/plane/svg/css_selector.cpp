// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/plane/svg/css_selector.h"

#include "core/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace scree {

namespace {

bool is_name(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || static_cast<unsigned char>(c) >= 0x80;
}

bool has_word(std::string_view list, std::string_view word) {
    while (!list.empty()) {
        const std::size_t begin = list.find_first_not_of(" \t\r\n\f");
        if (begin == std::string_view::npos)
            return false;
        list.remove_prefix(begin);
        const std::size_t end = std::min(list.find_first_of(" \t\r\n\f"), list.size());
        if (list.substr(0, end) == word)
            return true;
        list.remove_prefix(end);
    }
    return false;
}

} // namespace

/// One pass over a selector.
class CssSelectorParser {
  public:
    CssSelectorParser(std::string_view text, CssSelector& out) : text_(trimmed(text)), out_(out) {}

    void run() {
        char combinator = ' ';
        do {
            out_.parts_.push_back({combinator, compound()});
            combinator = next_combinator();
        } while (combinator != 0);
    }

  private:
    using Compound = CssSelector::Compound;

    [[noreturn]] void fail() const {
        throw Error(fmt::format("the selector \"{:.40}\" is not read", text_));
    }

    char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }

    bool take(char c) {
        if (peek() != c)
            return false;
        ++at_;
        return true;
    }

    void skip_blanks() {
        while (at_ < text_.size() &&
               std::string_view(" \t\r\n\f").find(text_[at_]) != std::string_view::npos)
            ++at_;
    }

    std::string name() {
        const std::size_t begin = at_;
        while (is_name(peek()))
            ++at_;
        if (at_ == begin)
            fail();
        return std::string(text_.substr(begin, at_ - begin));
    }

    /// 0 at the end.
    char next_combinator() {
        const std::size_t before = at_;
        skip_blanks();
        if (at_ == text_.size())
            return 0;
        for (const char c : {'>', '+', '~'})
            if (take(c)) {
                skip_blanks();
                return c;
            }
        if (at_ == before)
            fail();
        return ' ';
    }

    Compound compound() {
        Compound out;
        const std::size_t begin = at_;
        if (take('*') || is_name(peek())) {
            if (text_[begin] != '*')
                out.element = name();
            if (take('|')) { // a namespace before the name
                out.element.clear();
                if (!take('*'))
                    out.element = name();
            }
            out_.specificity_[2] += out.element.empty() ? 0 : 1;
        }
        while (true) {
            if (take('#')) {
                out.ids.push_back(name());
                ++out_.specificity_[0];
            } else if (take('.')) {
                out.classes.push_back(name());
                ++out_.specificity_[1];
            } else if (take('[')) {
                attribute(out);
                ++out_.specificity_[1];
            } else if (take(':')) {
                pseudo(out);
            } else {
                break;
            }
        }
        if (at_ == begin)
            fail();
        return out;
    }

    void attribute(Compound& out) {
        skip_blanks();
        CssSelector::AttributeTest test;
        test.name = name();
        skip_blanks();
        if (!take(']')) {
            test.kind = peek();
            if (std::string_view("=~|^$*").find(test.kind) == std::string_view::npos)
                fail();
            ++at_;
            if (test.kind != '=' && !take('='))
                fail();
            skip_blanks();
            test.value = value();
            skip_blanks();
            if (!take(']'))
                fail();
        }
        out.attributes.push_back(std::move(test));
    }

    std::string value() {
        const char quote = peek();
        if (quote != '"' && quote != '\'')
            return name();
        const std::size_t end = text_.find(quote, at_ + 1);
        if (end == std::string_view::npos)
            fail();
        std::string out(text_.substr(at_ + 1, end - at_ - 1));
        at_ = end + 1;
        return out;
    }

    std::string_view argument() {
        const std::size_t end = text_.find(')', at_);
        if (!take('(') || end == std::string_view::npos)
            fail();
        const std::string_view out = trimmed(text_.substr(at_, end - at_));
        at_ = end + 1;
        return out;
    }

    void pseudo(Compound& out) {
        if (take(':')) { // ::before
            name();
            out.never = true;
            ++out_.specificity_[2];
            return;
        }
        static constexpr std::array<std::string_view, 8> of_pointers{
            "hover", "active", "focus", "focus-visible", "visited", "target", "link", "any-link"};
        const std::string kind = lower_case(name());
        if (kind == "not") {
            const CssSelector inner(argument());
            for (std::size_t i = 0; i < 3; ++i)
                out_.specificity_[i] += inner.specificity_[i];
            out.not_these.push_back(inner);
            return;
        }
        ++out_.specificity_[1];
        if (kind == "root")
            out.root = true;
        else if (kind == "first-child" || kind == "only-child")
            out.children.push_back({0, 1, false});
        else if (std::find(of_pointers.begin(), of_pointers.end(), kind) != of_pointers.end())
            out.never = true;
        else if (kind == "nth-child" || kind == "nth-last-child")
            out.children.push_back(nth(lower_case(argument()), kind != "nth-child"));
        else if (kind != "last-child")
            fail();
        if (kind == "last-child" || kind == "only-child")
            out.children.push_back({0, 1, true});
    }

    /// odd, even, 3, 2n, 2n+1, -n+3.
    CssSelector::ChildTest nth(std::string text, bool from_end) const {
        std::erase_if(text, [](char c) { return c == ' ' || c == '\t'; });
        if (text == "odd")
            return {2, 1, from_end};
        if (text == "even")
            return {2, 0, from_end};
        const auto number = [&](std::string_view digits, int otherwise) {
            if (digits.starts_with('+'))
                digits.remove_prefix(1);
            if (digits.empty())
                return otherwise;
            int out = digits == "-" ? -1 : 0;
            const auto [end, code] =
                std::from_chars(digits.data(), digits.data() + digits.size(), out);
            if (digits != "-" && (code != std::errc{} || end != digits.data() + digits.size()))
                fail();
            return out;
        };
        const std::size_t n = text.find('n');
        if (n == std::string::npos)
            return {0, number(text, 0), from_end};
        return {number(std::string_view(text).substr(0, n), 1),
                number(std::string_view(text).substr(n + 1), 0), from_end};
    }

    std::string_view text_;
    std::size_t at_ = 0;
    CssSelector& out_;
};

CssSelector::CssSelector(std::string_view text) { CssSelectorParser(text, *this).run(); }

bool CssSelector::matches(const SvgNode& node, std::size_t part) const {
    if (!matches(node, parts_[part].compound))
        return false;
    if (part == 0)
        return true;
    const char combinator = parts_[part].combinator;
    if (combinator == ' ' || combinator == '>') {
        for (const SvgNode* outer = node.parent; outer != nullptr; outer = outer->parent) {
            if (matches(*outer, part - 1))
                return true;
            if (combinator == '>')
                return false;
        }
        return false;
    }
    for (std::size_t i = node.index; i-- > 0;) {
        if (matches(*node.parent->children[i], part - 1))
            return true;
        if (combinator == '+')
            return false;
    }
    return false;
}

bool CssSelector::matches(const SvgNode& node, const Compound& compound) {
    if (compound.never || (!compound.element.empty() && compound.element != node.name) ||
        (compound.root && node.parent != nullptr))
        return false;
    const auto text = [&](std::string_view name) {
        const std::string* value = node.attribute(name);
        return value == nullptr ? std::string_view() : std::string_view(*value);
    };
    const auto is_child = [&](const ChildTest& test) {
        if (node.parent == nullptr)
            return test.first == 1 || test.step != 0;
        const auto count = static_cast<int>(node.parent->children.size());
        const int place =
            test.from_end ? count - static_cast<int>(node.index) : static_cast<int>(node.index) + 1;
        const int steps = place - test.first;
        return test.step == 0 ? steps == 0 : steps % test.step == 0 && steps / test.step >= 0;
    };
    const auto has = [&](const AttributeTest& test) {
        const std::string* found = node.attribute(test.name);
        if (found == nullptr)
            return false;
        switch (test.kind) {
        case '=':
            return *found == test.value;
        case '~':
            return has_word(*found, test.value);
        case '|':
            return *found == test.value || found->starts_with(test.value + "-");
        case '^':
            return !test.value.empty() && found->starts_with(test.value);
        case '$':
            return !test.value.empty() && found->ends_with(test.value);
        case '*':
            return !test.value.empty() && found->find(test.value) != std::string::npos;
        default:
            return true;
        }
    };
    const auto all = [](const auto& list, const auto& test) {
        return std::all_of(list.begin(), list.end(), test);
    };
    return all(compound.ids, [&](const std::string& id) { return text("id") == id; }) &&
           all(compound.classes,
               [&](const std::string& name) { return has_word(text("class"), name); }) &&
           all(compound.attributes, has) && all(compound.children, is_child) &&
           all(compound.not_these, [&](const CssSelector& inner) { return !inner.matches(node); });
}

} // namespace scree
