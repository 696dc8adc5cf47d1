// SPDX-License-Identifier: GPL-3.0-or-later
// The only file of geometry that uses pugixml.
#include "geometry/plane/svg/svg_tree.h"

#include "core/text.h"

#include <fmt/format.h>
#include <pugixml.hpp>

#include <algorithm>

namespace scree {

namespace {

constexpr int deepest = 200; // drawings stay below 20
constexpr std::string_view svg_space = "http://www.w3.org/2000/svg";

class Builder {
  public:
    explicit Builder(const std::string& bytes) {
        for (std::size_t at = bytes.find('\n'); at != std::string::npos;
             at = bytes.find('\n', at + 1))
            line_ends_.push_back(at);
        const pugi::xml_parse_result result = document_.load_buffer(bytes.data(), bytes.size());
        if (!result)
            throw Error(fmt::format("line {}: {}", line_of(result.offset), result.description()));
        prefixes_.emplace_back("svg:");
        for (const pugi::xml_attribute& attribute : document_.document_element().attributes()) {
            const std::string_view name = attribute.name();
            if (name.starts_with("xmlns:") && attribute.value() == svg_space)
                prefixes_.push_back(std::string(name.substr(6)) + ":");
        }
    }

    std::unique_ptr<SvgNode> build() const {
        std::unique_ptr<SvgNode> root = made(document_.document_element(), nullptr, 0);
        if (root->name != "svg")
            root->fail(fmt::format("the file's element is \"{:.30}\", expected svg", root->name));
        return root;
    }

  private:
    std::size_t line_of(std::ptrdiff_t offset) const {
        const auto at = std::size_t(std::max<std::ptrdiff_t>(0, offset));
        return 1 + std::size_t(std::lower_bound(line_ends_.begin(), line_ends_.end(), at) -
                               line_ends_.begin());
    }

    std::string plain_name(std::string_view name) const {
        for (const std::string& prefix : prefixes_)
            if (name.starts_with(prefix))
                return std::string(name.substr(prefix.size()));
        return std::string(name);
    }

    std::unique_ptr<SvgNode> made(const pugi::xml_node& from, const SvgNode* parent,
                                  int depth) const {
        auto node = std::make_unique<SvgNode>();
        node->name = plain_name(from.name());
        node->line = line_of(from.offset_debug());
        node->parent = parent;
        if (depth > deepest)
            node->fail(fmt::format("elements are nested more than {} deep", deepest));
        for (const pugi::xml_attribute& attribute : from.attributes())
            node->attributes.emplace_back(attribute.name(), attribute.value());
        for (const pugi::xml_node& child : from.children())
            if (child.type() == pugi::node_element) {
                node->children.push_back(made(child, node.get(), depth + 1));
                node->children.back()->index = node->children.size() - 1;
            } else {
                node->text += child.value();
            }
        return node;
    }

    pugi::xml_document document_;
    std::vector<std::size_t> line_ends_;
    std::vector<std::string> prefixes_; // of SVG's namespace
};

} // namespace

const std::string* SvgNode::attribute(std::string_view attribute_name) const {
    const auto found = std::find_if(attributes.begin(), attributes.end(), [&](const auto& known) {
        return known.first == attribute_name;
    });
    return found == attributes.end() ? nullptr : &found->second;
}

std::string SvgNode::reference() const {
    const std::string* href = attribute("href");
    if (href == nullptr)
        href = attribute("xlink:href");
    const std::string_view target = href == nullptr ? std::string_view() : trimmed(*href);
    if (target.empty())
        return {};
    if (!target.starts_with('#'))
        fail(fmt::format("{}: refers to \"{:.60}\", outside the file", name, target));
    return std::string(target.substr(1));
}

void SvgNode::fail(const std::string& message) const {
    throw Error(fmt::format("line {}: {}", line, message));
}

std::unique_ptr<SvgNode> parse_svg_tree(const std::string& bytes) { return Builder(bytes).build(); }

} // namespace scree
