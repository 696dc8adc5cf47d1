// SPDX-License-Identifier: GPL-3.0-or-later
// The subcommands, one file each. Each declares its options and sets what to run.
#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace scree {

/// The function that main runs after parsing the command line; returns the exit code.
using Run = std::function<int()>;

void add_render_command(CLI::App& app, Run& run);
void add_analyse_command(CLI::App& app, Run& run);
void add_bake_command(CLI::App& app, Run& run);
void add_height_command(CLI::App& app, Run& run);
void add_texture_command(CLI::App& app, Run& run);
void add_view_command(CLI::App& app, Run& run);
void add_merge_command(CLI::App& app, Run& run);
void add_farm_command(CLI::App& app, Run& run);
void add_diff_command(CLI::App& app, Run& run);
void add_check_command(CLI::App& app, Run& run);
void add_list_command(CLI::App& app, Run& run);

} // namespace scree
