// SPDX-License-Identifier: GPL-3.0-or-later
// Which channels of an EXR are the picture: by their names, since files have any number of them.
#pragma once

#include "core/image_reading.h"

#include <span>
#include <string>
#include <vector>

namespace scree {

/// The channels of one layer of one part: those whose names agree up to the last dot.
struct ImageLayer {
    struct Channel {
        std::string name; // in the file: "ViewLayer.Combined.R"
        std::string role; // "R", "G", "B", "A", "Y", "RY" or "BY"; otherwise what follows the dot
    };
    int part = 0;
    std::string name;     // "ViewLayer.Combined"; of channels without a dot the part's name
    bool unnamed = false; // its channels have no dot
    std::vector<Channel> channels;

    const Channel* find(const std::string& role) const;
    bool has_color() const; // R, G and B, or Y
};

/// The layers of a part. Roles are recognised in any case, and as "red", "green", "blue" and
/// "alpha"; the Y beside an X is a coordinate and not a luminance.
std::vector<ImageLayer> layers_of_part(int part, const std::string& part_name,
                                       const std::vector<std::string>& channels);

/// The layer named `wanted`, in any case and by the end of its name that follows a dot.
///
/// When that is empty, of the layers with colours (for data: with R, G, B, A or Y) the one without
/// a name in the first part, else the only one, else the only one that is called combined, rgba,
/// rgb, beauty or color. For data it is the first layer when there are none with such channels.
///
/// Throws Error when there is none or more than one, naming what there is.
const ImageLayer& chosen_layer(std::span<const ImageLayer> layers, const std::string& wanted,
                               Meaning meaning);

} // namespace scree
