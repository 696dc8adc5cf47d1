// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/plane/svg/svg_tree.h"

#include <array>
#include <compare>
#include <string>
#include <string_view>
#include <vector>

namespace scree {

/// How many ids, classes (or the like) and element names a selector has; the greater one wins.
using Specificity = std::array<int, 3>;

/// A selector of CSS (Selectors 3): element names, *, classes, ids, attributes, :root, :not(),
/// :first-child, :last-child, :only-child, :nth-child(), descendants, children and siblings. What
/// depends on a pointer (:hover) and pseudo-elements match nothing.
class CssSelector {
  public:
    /// Throws Error for other selectors, naming them.
    explicit CssSelector(std::string_view text);

    bool matches(const SvgNode& node) const { return matches(node, parts_.size() - 1); }
    const Specificity& specificity() const { return specificity_; }

  private:
    struct AttributeTest {
        std::string name;
        char kind = 0; // 0: is there; '=', '~', '|', '^', '$', '*'
        std::string value;
    };
    struct ChildTest { // every `step`-th from `first`, counted from 1
        int step = 0;
        int first = 1;
        bool from_end = false;
    };
    struct Compound {
        std::string element; // empty: any
        std::vector<std::string> ids;
        std::vector<std::string> classes;
        std::vector<AttributeTest> attributes;
        std::vector<ChildTest> children;
        std::vector<CssSelector> not_these;
        bool root = false;
        bool never = false; // needs a pointer, or is no element
    };
    struct Part {
        char combinator = ' '; // with the part before: ' ', '>', '+', '~'
        Compound compound;
    };

    friend class CssSelectorParser;
    CssSelector() = default;

    bool matches(const SvgNode& node, std::size_t part) const;
    static bool matches(const SvgNode& node, const Compound& compound);

    std::vector<Part> parts_;
    Specificity specificity_{};
};

} // namespace scree
