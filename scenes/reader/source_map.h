// SPDX-License-Identifier: GPL-3.0-or-later
// The lines of the fields of a script's tables: Lua reports the lines of calls but not of fields.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace scree {

/// A table constructor `{ ... }` in a script, often an argument as in `generator.layout { ... }`.
struct TableSource {
    struct Item {
        std::string name; // "" for a positional item
        int line = 0;
        int table = -1; // index of the value's table when it is written as `{ ... }`
    };

    std::string callee; // "generator.layout"; "" when it is not an argument of a named function
    int callee_line = 0;
    int line = 0; // of the opening brace
    std::vector<Item> items;
    std::vector<std::size_t> by_name;  // items with names, in their order
    std::vector<std::size_t> in_order; // items without

    const Item* named(std::string_view name) const;
    const Item* positional(std::size_t index) const; // 0-based
};

/// All table constructors of one script.
class SourceMap {
  public:
    explicit SourceMap(std::string_view source);

    /// The table constructor that is the argument of the call `kind { ... }` on `line`, or null
    /// when none matches. `names` are its fields, which distinguish several tables on one line, up
    /// to a hundred: in a script on a single line there is nothing to tell apart.
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
