// SPDX-License-Identifier: GPL-3.0-or-later
// The command line of all benches.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

namespace scree::bench {

/// A table of a bench.
struct Table {
    std::string name;
    std::string what; // description, one line
    std::function<void()> print;
};

/// Prints the tables named on the command line, or all; `--help` lists them. Returns the exit code.
inline int run_tables(int count, char** arguments, const std::vector<Table>& tables) {
    std::setvbuf(stdout, nullptr, _IOLBF, 0); // lines appear as they are measured
    const std::vector<std::string> named(arguments + 1, arguments + count);
    const auto is_known = [&](const std::string& name) {
        return std::ranges::any_of(tables, [&](const Table& table) { return table.name == name; });
    };
    const auto unknown = std::ranges::find_if_not(named, is_known);
    if (unknown != named.end()) {
        const bool help = *unknown == "--help" || *unknown == "-h";
        std::FILE* out = help ? stdout : stderr;
        if (!help)
            fmt::print(out, "there is no table {}\n", *unknown);
        fmt::print(out, "Tables, all unless some are named:\n");
        for (const Table& table : tables)
            fmt::print(out, "  {:14} {}\n", table.name, table.what);
        return help ? 0 : 2;
    }
    for (const Table& table : tables)
        if (named.empty() || std::ranges::find(named, table.name) != named.end())
            table.print();
    return 0;
}

} // namespace scree::bench
