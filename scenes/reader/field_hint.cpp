// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenes/reader/field_hint.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace scree {

namespace {

std::vector<std::string> names_of(const std::vector<ParamSpec>& specs) {
    std::vector<std::string> names;
    names.reserve(specs.size());
    for (const ParamSpec& spec : specs)
        names.push_back(spec.name);
    return names;
}

const ParamSpec* find(const std::vector<ParamSpec>& specs, std::string_view name) {
    const auto found = std::ranges::find(specs, name, &ParamSpec::name);
    return found == specs.end() ? nullptr : &*found;
}

// "generator.layout.components" of "generator.layout "sweets".components[2]"
std::string plain_path(const std::string& path) {
    std::string out;
    bool quoted = false;
    bool indexed = false;
    for (const char c : path) {
        quoted = quoted != (c == '"');
        indexed = (indexed || c == '[') && c != ']';
        if (!quoted && !indexed && c != '"' && c != ']' && c != ' ')
            out += c;
    }
    return out;
}

// Whether the constructor has the field that the words name from outside in.
bool has_field(const std::vector<ParamSpec>& specs, std::span<const std::string> words) {
    const ParamSpec* spec = find(specs, words.front());
    return spec != nullptr && (words.size() == 1 || has_field(spec->fields, words.subspan(1)));
}

// The only constructor of the family that has such a field at this place; empty otherwise.
std::string other_owner(const std::string& name, std::span<const OpenTable> open) {
    std::size_t root = open.size() - 1; // the innermost constructor's table
    while (root > 0 && open[root].family == nullptr)
        --root;
    if (open[root].family == nullptr)
        return {};
    std::vector<std::string> words;
    for (std::size_t i = root + 1; i < open.size(); ++i) {
        const std::string path = plain_path(open[i].path);
        words.push_back(path.substr(path.rfind('.') + 1));
    }
    words.push_back(name);
    std::string owner;
    for (const Plugin<MakeObject>& plugin : open[root].family->plugins()) {
        if (!has_field(plugin.params, words))
            continue;
        if (!owner.empty())
            return {};
        owner = open[root].family->family() + "." + plugin.name;
    }
    return owner;
}

// The path of the innermost table around the last one that has the field; empty without any.
std::string table_around(const std::string& name, std::span<const OpenTable> open) {
    for (std::size_t i = open.size() - 1; i-- > 0;)
        if (find(open[i].specs, name) != nullptr)
            return plain_path(open[i].path);
    return {};
}

// Says where relief comes from, when a material is asked for it.
std::string relief_hint(const std::string& name, const OpenTable& table) {
    static const std::vector<std::string> words{"height", "bump",      "displacement",
                                                "normal", "normalmap", "relief"};
    if (table.family == nullptr || table.family->family() != "material" ||
        nearest_name(name, words).empty())
        return {};
    return "a material has no relief; generator.leather displaces a mesh; ";
}

} // namespace

std::string field_hint(const std::string& name, std::span<const OpenTable> open) {
    const std::vector<std::string> names = names_of(open.back().specs);
    std::string near = did_you_mean(name, names);
    if (const std::string around = table_around(name, open); !around.empty())
        return fmt::format("{} is a field of {}{}", name, around, near.empty() ? "" : "; " + near);
    if (!near.empty())
        return near;
    if (names.empty())
        return "it has no fields";
    const std::string owner = other_owner(name, open);
    return fmt::format("{}{}there are: {}", relief_hint(name, open.back()),
                       owner.empty() ? "" : owner + " has it; here ", fmt::join(names, ", "));
}

} // namespace scree
