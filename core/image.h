// SPDX-License-Identifier: GPL-3.0-or-later
// Image files: the only place that uses OpenImageIO and OpenEXR.
#pragma once

#include "core/warn.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace scree {

/// Interleaved float pixels, row 0 at the top; width * height * channels.size() values.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::string> channels; // "R", "G", "B", "A", "Y", "Z", ...
    std::vector<float> pixels;

    Image() = default;
    Image(int w, int h, std::vector<std::string> names)
        : width(w), height(h), channels(std::move(names)),
          pixels(std::size_t(w) * std::size_t(h) * channels.size()) {}

    float* at(int x, int y) {
        return &pixels[(std::size_t(y) * std::size_t(width) + std::size_t(x)) * channels.size()];
    }
    const float* at(int x, int y) const {
        return &pixels[(std::size_t(y) * std::size_t(width) + std::size_t(x)) * channels.size()];
    }
};

/// One part of a multi-part EXR: "beauty", "albedo", "variance", ...
struct ImagePart {
    std::string name;
    Image image;
    bool full_float = true; // false: 16-bit half
};

using Metadata = std::vector<std::pair<std::string, std::string>>;

/// Numeric attributes of an EXR header: one number is a float, two are a v2f, three a v3f.
using HeaderNumbers = std::vector<std::pair<std::string, std::vector<float>>>;

/// How to read an image.
struct ImageOptions {
    std::string layer{};    // of an EXR, as `chosen_layer` finds it; empty: the usual one
    Warn warn = no_warning; // of what is not honoured
};

/// Reads a picture: a PNG, JPEG, EXR or HDR (Radiance), with a limit on its size. It has channels
/// Y, Y A, R G B or R G B A, linear in Rec. 709 and premultiplied, finite and not negative, alpha
/// in [0, 1].
///
/// Honoured are the orientation in EXIF data; in PNG and JPEG the embedded profile, or PNG's cICP,
/// sRGB or gAMA and cHRM, else values count as sRGB; in EXR the channels' names, the layer, the
/// display window, which is the picture, and the chromaticities; in HDR the exposure, the
/// primaries and the order of pixels. Warned of are negative values, which become 0. Throws Error
/// (input) naming the file for what cannot be read right, such as CMYK, deep data and lookup tables
/// in profiles.
Image read_image(const std::string& path, const ImageOptions& options = {});

/// Reads the same files as data: the stored values, 8 and 16 bits scaled to [0, 1], without colour
/// conversion and without premultiplication. Of an EXR these are the layer's channels R, G, B, A
/// and Y, or all of them when it has none of these.
Image read_data_image(const std::string& path, const ImageOptions& options = {});

/// Where the pixels of a cropped picture lie in the whole one [pixels].
struct PictureWindow {
    int x = 0; // of the left column
    int y = 0; // of the top row
    int whole_width = 0;
    int whole_height = 0;
};

/// All parts of an EXR, and the first part's header: strings and non-standard numbers.
struct ExrFile {
    std::vector<ImagePart> parts;
    Metadata metadata;
    HeaderNumbers numbers;
    std::optional<PictureWindow> window{}; // of the first part, when it is not the whole picture
};
ExrFile read_exr(const std::string& path);

/// Writes a multi-part EXR atomically (zip compressed, every part with the metadata). With a window
/// the pixels are the data window in the display window of the whole picture. Throws Error
/// (resource) on an unwritable path or a full disk.
void write_exr(const std::string& path, std::span<const ImagePart> parts, const Metadata& metadata,
               const HeaderNumbers& numbers = {}, const std::optional<PictureWindow>& window = {});

/// Bits of a channel of a PNG.
enum class PngDepth { eight = 8, sixteen = 16 };

/// A PNG as bytes; `image` has 1, 3 or 4 channels already display-encoded in [0, 1]. One of 8 bits
/// is dithered by at most half a step with a fixed pattern, to hide banding. Throws Error
/// (resource) when encoding fails.
std::string png_bytes(const Image& image, const Metadata& metadata = {},
                      PngDepth depth = PngDepth::eight);

/// Writes such a PNG atomically. Throws Error (resource) on an unwritable path or a full disk.
void write_png(const std::string& path, const Image& image, const Metadata& metadata = {},
               PngDepth depth = PngDepth::eight);

} // namespace scree
