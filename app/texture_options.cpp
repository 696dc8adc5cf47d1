// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/texture_options.h"

#include "app/file_option.h"
#include "core/file.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>

namespace scree {

namespace {

// Names in the order of their enumerations.
const std::vector<std::string> map_names{"uv", "slices", "volume"};
const std::vector<std::string> texture_channels{"color", "height", "roughness", "value", "normal"};
const std::vector<std::string> axis_names{"x", "y", "z"};
const std::vector<std::string> texture_endings{"png", "exr", "vdb"};

constexpr int largest_picture = 16384; // pixels per side
constexpr int largest_volume = 1024;   // voxels per side

int texture_choice(const std::string& option, const std::string& given,
                   const std::vector<std::string>& names) {
    const auto found = std::find(names.begin(), names.end(), given);
    if (found == names.end())
        throw Error::usage(
            fmt::format("{} {}: expected one of {}", option, given, fmt::join(names, ", ")),
            did_you_mean(given, names));
    return static_cast<int>(found - names.begin());
}

void read_texture_size(const std::string& text, TextureRequest& request) {
    const bool volume = request.map == TextureMap::volume;
    const int largest = volume ? largest_volume : largest_picture;
    char rest = 0;
    const bool one = std::sscanf(text.c_str(), "%d%c", &request.width, &rest) == 1;
    const bool two =
        !one && !volume &&
        std::sscanf(text.c_str(), "%dx%d%c", &request.width, &request.height, &rest) == 2;
    const auto fits = [&](int side) { return side >= 1 && side <= largest; };
    if ((!one && !two) || !fits(request.width) || (two && !fits(request.height)))
        throw Error::usage(
            volume ? fmt::format("--size {}: expected a number of voxels along the longest side, "
                                 "1 to {}",
                                 text, largest)
                   : fmt::format("--size {}: expected N or WxH pixels, 1 to {}", text, largest),
            volume ? "for example --size 128" : "for example --size 2048");
}

} // namespace

void TextureOptions::add_to(CLI::App& command) {
    scene.add_to(command);
    add_file_option(command, "-o,--output", output, "File to write: .png, .exr or .vdb")
        ->required();
    command
        .add_option("--object", object,
                    "Which of scene.objects, by its name or counted from 1, when several have a "
                    "procedural; the others are not made")
        ->type_name("N|NAME");
    command
        .add_option("--map", map,
                    "uv: a texture over the mesh's UVs; slices: parallel cuts through its bounding "
                    "box; volume: voxels (default: volume for .vdb, otherwise uv)")
        ->type_name("uv|slices|volume");
    command
        .add_option("--channel", channel,
                    "color, height [m], roughness, value, or normal (a tangent-space normal map)")
        ->type_name("NAME");
    command
        .add_option("--size", size,
                    "Pixels of a texture (default 1024), of a slice's longer side (512), voxels "
                    "along the longest side (128)")
        ->type_name("N|WxH");
    command.add_option("--slices", slices, "Number of slices (default 8)")
        ->check(CLI::Range(1, 1024));
    command.add_option("--axis", axis, "What slices are across (default z)")->type_name("x|y|z");
    add_stats_option(command, stats);
    command.footer("Example:\n"
                   "  scree texture vase.lua -o vase.png --size 2048\n"
                   "  scree texture vase.lua -o vase_normal.exr --channel normal\n"
                   "  scree texture vase.lua -o slices.png --map slices --axis x\n"
                   "  scree texture vase.lua -o vase.vdb --size 256");
}

TextureRequest TextureOptions::request() const {
    TextureRequest out;
    out.ending = extension(output);
    if (std::find(texture_endings.begin(), texture_endings.end(), out.ending) ==
        texture_endings.end())
        throw Error::usage(output + ": expected a name that ends in .png, .exr or .vdb");
    const bool vdb = out.ending == "vdb";
    out.map = map.empty() ? (vdb ? TextureMap::volume : TextureMap::uv)
                          : TextureMap(texture_choice("--map", map, map_names));
    if (!channel.empty())
        out.channel = TextureChannel(texture_choice("--channel", channel, texture_channels));
    if (!axis.empty())
        out.axis = texture_choice("--axis", axis, axis_names);
    if (slices > 0)
        out.slices = slices;

    const auto refuse = [](const std::string& message, const std::string& hint) {
        throw Error::usage(message, hint);
    };
    const bool volume = out.map == TextureMap::volume;
    if (vdb && !volume)
        refuse(fmt::format("--map {}: a .vdb holds a volume", map), "write a .png or .exr");
    if (volume && out.ending == "png")
        refuse(output + ": a volume is written as .vdb or .exr", "or see --map slices");
    if (vdb && !channel.empty())
        refuse("--channel: a .vdb holds the grids density (value) and color", "leave it away");
    if (out.channel == TextureChannel::normal && out.map != TextureMap::uv)
        refuse("--channel normal: a normal map lies over UVs", "use --map uv");
    if (out.channel == TextureChannel::height && out.ending == "png")
        refuse(output + ": heights in metres do not fit into a .png", "write an .exr");
    if (slices > 0 && out.map != TextureMap::slices)
        refuse(fmt::format("--slices is for --map slices, not {}", map_names[std::size_t(out.map)]),
               volume ? "the number of layers follows from --size" : "");
    if (!axis.empty() && (out.map == TextureMap::uv || vdb))
        refuse("--axis is for --map slices, and for volumes as .exr", "leave it away");

    read_texture_size(!size.empty()                   ? size
                      : out.map == TextureMap::uv     ? "1024"
                      : out.map == TextureMap::slices ? "512"
                                                      : "128",
                      out);
    return out;
}

} // namespace scree
