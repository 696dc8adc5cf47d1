// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.h"
#include "app/file_option.h"
#include "app/picture_output.h"
#include "app/standard_streams.h"
#include "session/merge_shards.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace scree {

namespace {

struct MergeOptions {
    std::vector<std::string> shards;
    std::string output;
};

int merge(const MergeOptions& options) {
    check_picture_output(options.output);
    const MergedShards merged = merge_shards(options.shards);
    write_exr(options.output, merged.picture.parts, merged.picture.metadata, merged.picture.numbers,
              merged.picture.window);
    write_look(beside(options.output, "png"), merged.picture.parts.front().image, merged.look);
    tell(fmt::format("wrote {} and {}\n", options.output, beside(options.output, "png")));
    return 0;
}

} // namespace

void add_merge_command(CLI::App& app, Run& run) {
    auto options = std::make_shared<MergeOptions>();
    CLI::App* command = app.add_subcommand(
        "merge", "Put the shards of a picture together (scree render --shard I/N).");
    command->add_option("SHARD", options->shards, "The .exr of every shard, in any order")
        ->required();
    add_file_option(*command, "-o,--output", options->output,
                    "File to write: .exr, with a .png beside it")
        ->required();
    command->footer("The result has the bytes of a picture that was rendered in one piece.\n"
                    "Example:\n"
                    "  scree render scenes/toys.lua --shard 1/2 -o a.exr\n"
                    "  scree render scenes/toys.lua --shard 2/2 -o b.exr\n"
                    "  scree merge a.exr b.exr -o toys.exr");
    command->callback([options, &run] { run = [options] { return merge(*options); }; });
}

} // namespace scree
