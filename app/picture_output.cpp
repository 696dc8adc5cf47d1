// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/picture_output.h"

#include "core/error.h"

#include <CLI/CLI.hpp>

namespace scree {

void add_png_bits_option(CLI::App& command, PngDepth& depth) {
    command
        .add_option_function<int>(
            "--png-bits",
            [&depth](int bits) { depth = bits == 16 ? PngDepth::sixteen : PngDepth::eight; },
            "Bits of each channel of the .png: 8 (the default) or 16")
        ->check(CLI::IsMember({8, 16}))
        ->type_name("BITS");
}

Image write_look(const std::string& png, const Image& image, const PngLook& look) {
    Image shown = to_display(image, look.view, look.exposure);
    write_png(png, shown, {}, look.depth);
    return shown;
}

void check_picture_output(const std::string& path) {
    if (extension(path) != "exr")
        throw Error::usage(path + ": expected a name that ends in .exr",
                           "the PNG to look at is written beside it");
    check_writable(path);
}

std::string default_picture(const std::string& scene) {
    const std::string script = file_name(scene);
    return script.substr(0, script.rfind('.')) + ".exr";
}

std::string beside(const std::string& exr, const std::string& ending) {
    return exr.substr(0, exr.size() - 3) + ending;
}

} // namespace scree
