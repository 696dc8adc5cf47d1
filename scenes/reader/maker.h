// SPDX-License-Identifier: GPL-3.0-or-later
// Constructors' tables against the plug-ins' declarations, and the objects that they make.
#pragma once

#include "scenes/reader/check_value.h"
#include "scenes/reader/plugins.h"

#include <algorithm>
#include <optional>
#include <unordered_map>

namespace scree {

/// Checks nodes and makes what they name, each node once. Mistakes are collected; what could not be
/// made is null (or the default material).
class Maker {
  public:
    explicit Maker(Mistakes& mistakes) : mistakes_(mistakes) {}

    /// The fields of a table as parameters with their defaults; notes unknown, missing and wrong
    /// ones. `path` is the table's own: "generator.layout.components[2]".
    Params params(const Description& table, const std::string& path,
                  const std::vector<ParamSpec>& specs);

    /// The plug-in that a node names, or null after noting that there is none of that family.
    template <class Make>
    const Plugin<Make>* plugin(const Registry<Make>& table, const Given& given);

    /// Checks the node's fields and calls its plug-in; none after a mistake.
    template <class T, class Make>
    std::optional<T> make(const Registry<Make>& table, const Given& given);

    const std::vector<Material>& materials() const { return materials_; }

    /// A list's items, or null after noting that the value is none.
    const Description::List* list(const Given& given, const std::string& expected);

  private:
    template <class T>
    using Made = std::unordered_map<const Description*, T>;

    Value value(const Given& given, const ParamSpec& spec);
    Value texture(const Given& given, const ParamSpec& spec);
    Value material(const Given& given);
    Value shape(const Given& given, const ParamSpec& spec);
    Value field(const Given& given, const ParamSpec& spec);
    Value record(const Given& given, const ParamSpec& spec);
    Value records(const Given& given, const ParamSpec& spec);
    Value absent(const Description& table, const std::string& path, const ParamSpec& spec);
    Value wrong_kind(const Given& given, const ParamSpec& spec);

    template <class T, class Make>
    std::shared_ptr<const T> shared(Made<std::shared_ptr<const T>>& made,
                                    const Registry<Make>& table, const Given& given);

    Mistakes& mistakes_;
    std::vector<Material> materials_{Material(Matte{})};
    Made<std::shared_ptr<const Mesh>> meshes_;
    Made<std::shared_ptr<const Region>> regions_;
    Made<std::shared_ptr<const Field>> fields_;
    Made<std::shared_ptr<const Procedural>> procedurals_;
    Made<MaterialId> material_ids_;
};

/// "mesh" of "mesh.banana".
inline std::string_view family_of(const Description& node) {
    return std::string_view(node.kind).substr(0, node.kind.find('.'));
}

template <class Make>
const Plugin<Make>* Maker::plugin(const Registry<Make>& table, const Given& given) {
    const std::string& kind = given.value.kind;
    const std::string name = kind.substr(std::min(kind.find('.'), kind.size() - 1) + 1);
    if (const Plugin<Make>* found = table.find(name))
        return found;
    std::vector<std::string> names;
    std::string all;
    for (const Plugin<Make>& known : table.plugins()) {
        names.push_back(known.name);
        all += (all.empty() ? "" : ", ") + known.name;
    }
    const std::string near = nearest_name(name, names);
    mistakes_.add(given.value.where, kind, "unknown " + table.family(),
                  near.empty() ? "there are: " + all
                               : "did you mean " + table.family() + "." + near + "?");
    return nullptr;
}

template <class T, class Make>
std::optional<T> Maker::make(const Registry<Make>& table, const Given& given) {
    const Plugin<Make>* found = plugin(table, given);
    if (found == nullptr)
        return {};
    const std::size_t before = mistakes_.count();
    const Params checked = params(given.value, given.value.kind, found->params);
    if (mistakes_.count() != before)
        return {};
    try {
        return found->make(checked);
    } catch (const Error& error) {
        if (error.fault() != Fault::input)
            throw;
        mistakes_.add(error, given.value.where, given.value.kind);
        return {};
    }
}

} // namespace scree
