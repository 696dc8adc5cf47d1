// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image.h"
#include "core/math.h"

#include <string>
#include <string_view>

namespace scree {

/// A picture in the layout plane: pixels with alpha, and the SVG drawing that they were rasterised
/// from, if any.
struct Picture {
    std::string name;    // as shown to users: "leaf.png"
    Image image;         // R, G, B, A: linear Rec. 709, premultiplied; row 0 on the far side (-z)
    std::string drawing; // an SVG document as `read_drawing` returns it; empty: none
    Box2 box;            // the area it covers (x, z), in its prototype's frame [m]
};

/// Default number of pixels along the longer side of a rasterised drawing.
inline constexpr int drawing_pixels = 512;

/// Reads an image as `read_image` does (with or without alpha), or an SVG drawing, which is also
/// rasterised with `pixels` pixels along its longer side. The box is centred on the origin, its
/// longer side 1 m. Throws Error (input) naming the file when it is missing, corrupt or too large,
/// or is a drawing that `read_drawing` rejects.
Picture read_picture(const std::string& path, int pixels = drawing_pixels,
                     const ImageOptions& options = {});

/// The same of the bytes of such a file, named `name` in messages. Throws also Error (resource)
/// when there is no memory for them.
Picture read_picture_bytes(const std::string& name, std::string_view bytes);

} // namespace scree
