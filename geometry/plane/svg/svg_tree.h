// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/error.h"

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace scree {

/// An element of an SVG file.
struct SvgNode {
    std::string name; // without the prefix of SVG's namespace; others keep theirs: "sodipodi:guide"
    std::vector<std::pair<std::string, std::string>> attributes;
    std::vector<std::unique_ptr<SvgNode>> children; // elements only
    std::string text;                               // directly inside
    const SvgNode* parent = nullptr;
    std::size_t index = 0; // in its parent's children
    std::size_t line = 0;

    /// The attribute's value, or null.
    const std::string* attribute(std::string_view attribute_name) const;

    /// What an href (or xlink:href) refers to in the file, without the #; empty when there is none.
    /// Throws Error for a reference out of the file.
    std::string reference() const;

    /// Throws Error with the line.
    [[noreturn]] void fail(const std::string& message) const;

    /// What `read` returns; what it throws, with the element's line and name.
    template <class Read>
    auto located(const Read& read) const {
        try {
            return read();
        } catch (const Error& error) {
            fail(name + ": " + error.diagnostics().front().message);
        }
    }
};

/// Parses a file's bytes. Throws Error naming the line for what is not XML, another document than
/// SVG and elements nested more than 200 deep.
std::unique_ptr<SvgNode> parse_svg_tree(const std::string& bytes);

/// Calls `visit` for the element and all in it, parents first.
template <class Visit>
void for_each_node(const SvgNode& node, const Visit& visit) {
    visit(node);
    for (const std::unique_ptr<SvgNode>& child : node.children)
        for_each_node(*child, visit);
}

} // namespace scree
