// SPDX-License-Identifier: GPL-3.0-or-later
// PNG and JPEG files taken apart into their pixels and what is said of them.
#pragma once

#include "core/exif.h"
#include "core/image_reading.h"

#include <map>
#include <string>
#include <string_view>

namespace scree {

/// A file without its metadata, and these. OpenImageIO is given only the former, since it crashes
/// on damaged profiles (version 2.4 does on a tag `text` of 4 bytes).
struct TaggedImage {
    std::string bytes;   // what is needed to decode the pixels
    std::string profile; // of a JPEG: an ICC profile; empty: none
    ExifFacts exif;
    std::map<std::string, std::string> chunks; // of a PNG: cICP, iCCP, sRGB, gAMA, cHRM
    int components = 0;                        // of a JPEG: 1 grey, 3 colours, 4 CMYK
};

TaggedImage take_apart_png(std::string_view file);

TaggedImage take_apart_jpeg(std::string_view file);

/// What the values mean: by the first that is there of cICP, a profile, sRGB, gAMA and cHRM (PNG 3,
/// section 4.3), and the colour space in EXIF data; sRGB when there is nothing. A gAMA of 1/2.2
/// stands for sRGB. Throws Error for what cannot be converted.
ColorEncoding encoding_of(const TaggedImage& image, const Warn& warn);

} // namespace scree
