// SPDX-License-Identifier: GPL-3.0-or-later
// A picture is written as an .exr, and beside it a .png to look at.
#pragma once

#include "core/file.h"
#include "core/image.h"
#include "render/film/color.h"

#include <string>

namespace CLI {
class App;
}

namespace scree {

/// Adds --png-bits.
void add_png_bits_option(CLI::App& command, PngDepth& depth);

/// Writes what a view shows of a picture of linear light, and answers it. Throws Error as
/// to_display and write_png.
Image write_look(const std::string& png, const Image& image, const PngLook& look);

/// Throws Error unless `path` ends in .exr (usage) and can be written (resource).
void check_picture_output(const std::string& path);

/// The picture of a scene when none is named: "toys.exr" in the current folder for "a/toys.lua".
std::string default_picture(const std::string& scene);

/// "toys.png" for "toys.exr" and "png".
std::string beside(const std::string& exr, const std::string& ending);

} // namespace scree
