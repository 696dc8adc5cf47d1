// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/file_option.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace scree {

CLI::Option* add_file_option(CLI::App& command, const std::string& names, std::string& path,
                             const std::string& doc) {
    const auto check = [](const std::string& given) {
        return given.starts_with("-")
                   ? fmt::format("expected the name of a file, got {}; a file of this name is ./{}",
                                 given, given)
                   : std::string();
    };
    return command.add_option(names, path, doc)->check(check)->type_name("FILE");
}

void add_stats_option(CLI::App& command, std::string& path) {
    add_file_option(command, "--stats", path, "Write counts, times and memory as JSON");
}

} // namespace scree
