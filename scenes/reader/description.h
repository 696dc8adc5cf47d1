// SPDX-License-Identifier: GPL-3.0-or-later
// The parsed scene: a tree of plain values with file and line, before any object is made.
#pragma once

#include "core/error.h"

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace scree {

struct Description;
using DescriptionNode = std::shared_ptr<const Description>;

/// One value of a scene. A table that a script uses in two places is one node with two parents, so
/// that its object is made only once. There are no cycles.
struct Description {
    /// A value in a list or table, and the line in the container's file where it is used, which
    /// differs from the value's own location when it is shared.
    struct Item {
        DescriptionNode value;
        int line = 0;
    };
    using List = std::vector<Item>;
    using Table = std::map<std::string, Item>; // sorted, for a deterministic order
    using Data = std::variant<std::monostate, bool, std::int64_t, double, std::string, List, Table>;

    Location where;
    std::string kind; // "mesh.file", "generator.layout", "scene"; "" for a plain value
    Data data;
};

/// Runs a .lua scene script in a sandboxed child process, or reads a .json description. `families`
/// are those of the constructors that a script may call ("mesh", ...), as listed by
/// Catalog::constructor_families(). `overrides` are the values of --set; an override that no
/// arg(...) uses is an error. `readable_folders` are those from which a script may include files,
/// beside its own. Throws Error with all errors found.
DescriptionNode read_description(const std::string& path,
                                 const std::map<std::string, std::string>& overrides,
                                 const std::vector<std::string>& families,
                                 const std::vector<std::string>& readable_folders = {});

/// Options of to_json. Without locations the text does not change when lines of the script move.
struct JsonStyle {
    bool locations = true;
    bool indent = true;
};

/// The description as JSON, from which read_description makes an equal description.
std::string to_json(const Description& description, JsonStyle style = {});

} // namespace scree
