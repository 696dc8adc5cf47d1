// SPDX-License-Identifier: GPL-3.0-or-later
// The program: parses the command line, runs one command, and maps errors to exit codes.
#include "app/commands.h"
#include "app/interruption.h"
#include "app/standard_streams.h"
#include "core/error.h"
#include "core/progress.h"
#include "core/version.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <new>
#include <sstream>

namespace scree {
namespace {

constexpr int exit_internal = 70; // sysexits.h EX_SOFTWARE: a programming error

const CLI::App& innermost(const CLI::App& app) {
    const CLI::App* command = &app;
    while (!command->get_subcommands().empty())
        command = command->get_subcommands().front();
    return *command;
}

std::string command_name(const CLI::App& command) {
    return command.get_parent() == nullptr ? "scree" : "scree " + command.get_name();
}

bool has_unknown_option(const CLI::App& app) {
    const std::vector<std::string> extras = app.remaining(true);
    return !extras.empty() && extras.front().starts_with("-");
}

std::vector<std::string> option_names(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options())
        for (const std::string& name : option->get_lnames())
            names.push_back("--" + name);
    return names;
}

// CLI11 reports only that an argument was not expected; this names the nearest valid one.
Error unknown_argument(const CLI::App& app) {
    const CLI::App& command = innermost(app);
    const std::vector<std::string> extras = app.remaining(true);
    const std::string given =
        extras.empty() ? "" : extras.front().substr(0, extras.front().find('='));
    if (given.starts_with("-"))
        return Error::usage(fmt::format("{}: unknown option {}", command_name(command), given),
                            did_you_mean(given, option_names(command)));
    if (&command != &app)
        return Error::usage(
            fmt::format("{}: unexpected argument {}", command_name(command), given));
    std::vector<std::string> commands;
    for (const CLI::App* sub : app.get_subcommands({}))
        commands.push_back(sub->get_name());
    return Error::usage("unknown command " + given, did_you_mean(given, commands));
}

// `test` and `bench` need the source tree: the launcher script of a checkout handles them before
// this program is started.
void add_launcher_commands(CLI::App& app, Run& run) {
    for (const auto& [name, what] :
         {std::pair{"test", "Build and run the tests (from a checkout: ./scree test)."},
          std::pair{"bench", "Print the measured tables (from a checkout: ./scree bench)."}}) {
        CLI::App* command = app.add_subcommand(name, what);
        command->callback([&run, name = std::string(name)] {
            run = [name]() -> int {
                throw Error::usage(
                    fmt::format("`scree {0}` runs from a source checkout: ./scree {0}", name));
            };
        });
    }
}

int run_command_line(int argc, char** argv) {
    CLI::App app{"Scree makes pictures of, and geometry for, things made of many small things.",
                 "scree"};
    app.set_version_flag("--version", "scree " SCREE_VERSION);
    app.require_subcommand(0, 1);
    app.footer(
        "Example:\n  scree render scenes/toys.lua -o toys.exr\n"
        "`scree COMMAND --help` shows a command's options with an example.\n"
        "Exit codes: 0, 1 a mistake in what was given, 2 in how it was called, 3 no room, no\n"
        "memory or no device, 130 interrupted (128 + the signal).");
    Run run;
    add_render_command(app, run);
    add_bake_command(app, run);
    add_height_command(app, run);
    add_texture_command(app, run);
    add_view_command(app, run);
    add_merge_command(app, run);
    add_diff_command(app, run);
    add_farm_command(app, run);
    add_analyse_command(app, run);
    add_check_command(app, run);
    add_list_command(app, run);
    add_launcher_commands(app, run);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ExtrasError&) {
        throw unknown_argument(app);
    } catch (const CLI::ParseError& problem) {
        if (problem.get_exit_code() == 0) { // --help, --version
            std::ostringstream text;
            app.exit(problem, text, text);
            print_result(text.str());
            return 0;
        }
        if (has_unknown_option(app))
            throw unknown_argument(app); // it may be why another argument is missing
        const std::string name = command_name(innermost(app));
        throw Error::usage(fmt::format("{}: {}", name, problem.what()),
                           fmt::format("see {} --help", name));
    }
    if (!run) {
        tell(app.help());
        return static_cast<int>(Fault::usage);
    }
    return run();
}

// The exit code of `run`, which may throw.
int reported(const Run& run) {
    try {
        return run();
    } catch (const Error& error) {
        tell(std::string(error.what()) + "\n");
        return static_cast<int>(error.fault());
    } catch (const Cancelled&) {
        tell("cancelled\n");
        return interrupted_exit_code();
    } catch (const std::bad_alloc&) {
        tell("out of memory\n");
        return static_cast<int>(Fault::resource);
    } catch (const std::exception& failure) {
        tell(fmt::format(
            "internal error: {}\nThis is a mistake in Scree itself; please report it.\n",
            failure.what()));
        return exit_internal;
    }
}

} // namespace
} // namespace scree

int main(int argc, char** argv) {
    scree::fill_closed_streams();
    scree::heed_signals();
    return scree::reported([&] {
        const int code = scree::run_command_line(argc, argv);
        scree::finish_results();
        return code;
    });
}
