// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace CLI {
class App;
class Option;
} // namespace CLI

namespace scree {

/// Adds an option that names a file to write. It refuses a value that begins with "-": the option
/// that follows where the name was forgotten.
CLI::Option* add_file_option(CLI::App& command, const std::string& names, std::string& path,
                             const std::string& doc);

/// Adds --stats.
void add_stats_option(CLI::App& command, std::string& path);

} // namespace scree
