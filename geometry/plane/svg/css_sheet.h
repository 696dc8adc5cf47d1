// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/plane/svg/css_selector.h"

#include <map>

namespace scree {

/// Properties with their values, by names in lower case (custom ones, --name, as written).
using CssProperties = std::map<std::string, std::string>;

/// The style sheets of a drawing and their cascade (CSS 2.1, section 6.4; Selectors 3).
class CssSheet {
  public:
    /// Adds what an element `style` holds. Rules in @media for light screens and all media count,
    /// those for print do not; @font-face, @page, @keyframes, @charset and @namespace draw nothing.
    /// Throws Error for other at-rules, escapes, nested rules and selectors that are not read.
    void add(std::string_view text);

    /// What the rules and the element's attribute `style` declare: by importance, then the
    /// attribute before rules, then specificity, then order.
    CssProperties declared(const SvgNode& node) const;

  private:
    struct Declaration {
        std::string name;
        std::string value;
        bool important = false;
    };
    struct Rule {
        CssSelector selector;
        std::size_t block = 0;
    };

    static std::vector<Declaration> declarations(std::string_view block);
    void add_rules(std::string_view text);
    void add_at_rule(std::string_view name, std::string_view prelude, std::string_view block);

    std::vector<Rule> rules_; // in their order
    std::vector<std::vector<Declaration>> blocks_;
};

/// The parts of a text between `separator`s that stand outside brackets and quotes.
std::vector<std::string_view> css_split(std::string_view text, char separator);

} // namespace scree
