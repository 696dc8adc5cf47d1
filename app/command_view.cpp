// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.h"
#include "app/exr_part.h"
#include "app/file_option.h"
#include "app/picture_output.h"
#include "app/standard_streams.h"
#include "core/error.h"
#include "core/file.h"
#include "core/image.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <memory>

namespace scree {

namespace {

struct ViewOptions {
    std::string input;
    std::string output;
    std::string part; // empty: the first
    PngLook look;
};

ExrFile read_picture(const std::string& path) {
    if (extension(path) != "hdr")
        return read_exr(path);
    ExrFile out;
    out.parts.push_back({{}, read_image(path)});
    return out;
}

int view(const ViewOptions& options) {
    if (extension(options.output) != "png")
        throw Error::usage(options.output + ": expected a name that ends in .png");
    check_writable(options.output);
    const ExrFile file = read_picture(options.input);
    const ImagePart& part =
        options.part.empty() ? file.parts.front() : named_part(file, options.input, options.part);
    write_look(options.output, part.image, options.look);
    if (options.part.empty() && file.parts.size() > 1)
        tell(fmt::format("shows the first part of {}; its parts are: {}\n", options.input,
                         part_names(file)));
    return 0;
}

} // namespace

void add_view_command(CLI::App& app, Run& run) {
    auto options = std::make_shared<ViewOptions>();
    CLI::App* command = app.add_subcommand(
        "view", "Turn an .exr or .hdr into a .png to look at, through OpenColorIO.");
    command->add_option("FILE", options->input, "Picture to read: .exr or .hdr")->required();
    add_file_option(*command, "-o,--output", options->output, "File to write: .png")->required();
    command->add_option("--part", options->part, "Part of a multi-part .exr (default: the first)")
        ->type_name("NAME");
    command->add_option("--view", options->look.view, "View of the OpenColorIO configuration")
        ->type_name("NAME");
    add_png_bits_option(*command, options->look.depth);
    command->add_option("--exposure", options->look.exposure, "Brighter by this many stops")
        ->check(CLI::Range(-32.0, 32.0))
        ->type_name("STOPS");
    command->footer("Views of the built-in configuration: filmic (the default), standard\n"
                    "(sRGB) and raw (linear values as they are).\n"
                    "$OCIO names another configuration.\n"
                    "Example:\n  scree view toys.exr -o toys.png --view standard --exposure 0.5");
    command->callback([options, &run] { run = [options] { return view(*options); }; });
}

} // namespace scree
