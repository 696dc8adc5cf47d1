// SPDX-License-Identifier: GPL-3.0-or-later
// The parsed scene: a tree of plain values, each with file and line; no objects yet.
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

/// One value of a scene. A node that a script uses twice is one node with two parents, so that a
/// mesh named once is made once; there are no cycles.
struct Description {
    /// A value in its holder, and the line of the holder's file where it stands: a shared value
    /// was written elsewhere.
    struct Item {
        DescriptionNode value;
        int line = 0;
    };
    using List = std::vector<Item>;
    using Table = std::map<std::string, Item>; // sorted: the same order every run
    using Data = std::variant<std::monostate, bool, std::int64_t, double, std::string, List, Table>;

    Location where;
    std::string kind; // "mesh.file", "generator.layout", "scene"; "" for a plain value
    Data data;
};

/// Runs a .lua scene script in a sandboxed child process, or reads a .json description. A script
/// knows the constructors of `families`, "mesh" and so on, as Catalog::constructor_families()
/// lists. `overrides` are the values of --set; an override that no arg(...) asks for is an error.
/// Throws Error with every mistake found.
DescriptionNode read_description(const std::string& path,
                                 const std::map<std::string, std::string>& overrides,
                                 const std::vector<std::string>& families);

/// How to_json writes. Without locations the text depends on the scene alone, not on where its
/// lines stand.
struct JsonStyle {
    bool locations = true;
    bool indent = true;
};

/// The description as JSON text that read_description reads back to the same description.
std::string to_json(const Description& description, JsonStyle style = {});

} // namespace scree
