// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.h"
#include "app/reference.h"
#include "app/standard_streams.h"
#include "core/error.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace scree {

namespace {

struct ListOptions {
    std::string name;
    bool markdown = false;
};

int list(const ListOptions& options) {
    const std::vector<CatalogRow> rows = catalog_rows(standard_catalog());
    if (options.markdown) {
        print_result(reference_markdown(rows));
        return 0;
    }
    if (options.name.empty()) {
        print_result(plugin_overview(rows));
        return 0;
    }
    std::vector<std::string> names;
    bool found = false;
    for (const CatalogRow& row : rows) {
        const std::string full = full_name(row);
        names.push_back(full);
        if (full != options.name && row.family != options.name && row.name != options.name)
            continue;
        print_result(fmt::format("{}{}", found ? "\n" : "", plugin_details(row)));
        found = true;
    }
    if (!found)
        throw Error::usage("scree list: nothing is called " + options.name,
                           did_you_mean(options.name, names));
    return 0;
}

} // namespace

void add_list_command(CLI::App& app, Run& run) {
    auto options = std::make_shared<ListOptions>();
    CLI::App* command =
        app.add_subcommand("list", "Show what a scene can be made of, with every parameter.");
    command->add_option("NAME", options->name, "A family or one of its members: mesh, mesh.banana");
    command->add_flag("--markdown", options->markdown, "Print the whole reference as Markdown");
    command->footer("Example:\n  scree list generator.layout");
    command->callback([options, &run] { run = [options] { return list(*options); }; });
}

} // namespace scree
