// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image.h"
#include "core/math.h"

#include <string>

namespace scree {

/// A picture that lies on the ground: pixels with alpha, and the drawing that they were made from
/// when its file was one.
struct Picture {
    std::string name; // as shown to users: "leaf.png"
    Image image;      // R, G, B, A: linear Rec. 709 multiplied by alpha; row 0 on the far side (-z)
    std::string drawing; // an SVG document as `read_drawing` returns it; empty: none
    Box2 box;            // what it covers of the layout plane (x, z), in its prototype's frame [m]
};

/// Pixels along the longer side that a drawing gets unless told otherwise.
inline constexpr int drawing_pixels = 512;

/// Reads a PNG, JPEG or EXR (with alpha or without), or an SVG drawing, which is also rasterised
/// with `pixels` pixels along its longer side. The box is about the origin, its longer side 1 m.
/// Throws Error (input) naming the file: missing, broken, too large, channels that are no colour,
/// or a drawing that `read_drawing` refuses.
Picture read_picture(const std::string& path, int pixels = drawing_pixels);

} // namespace scree
