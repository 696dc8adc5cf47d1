// SPDX-License-Identifier: GPL-3.0-or-later
// Where the fields of a script's tables stand. Lua knows the line of a call, not of a field.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace scree {

/// One `{ ... }` of a script, perhaps an argument as in `generator.layout { ... }`.
struct TableSource {
    struct Item {
        std::string name; // "" for a positional item
        int line = 0;
        int table = -1; // index of the value when it is itself written as `{ ... }`
    };

    std::string callee; // "generator.layout"; "" when it is no argument of a named function
    int callee_line = 0;
    int line = 0; // of the opening brace
    std::vector<Item> items;

    const Item* named(std::string_view name) const;
    const Item* positional(std::size_t index) const; // 0-based
};

/// All tables of one script.
class SourceMap {
  public:
    explicit SourceMap(std::string_view source);

    /// The table that the call `kind { ... }` on `line` was given, or null when none is likely.
    /// `names` are the fields that it has, which tell apart several tables of one line.
    const TableSource* find(std::string_view kind, int line,
                            const std::vector<std::string>& names) const;

    const TableSource* at(int index) const {
        return index < 0 ? nullptr : &tables_[static_cast<std::size_t>(index)];
    }
    const std::vector<TableSource>& tables() const { return tables_; }

  private:
    std::vector<TableSource> tables_;
    std::multimap<int, std::size_t> by_line_;
};

} // namespace scree
