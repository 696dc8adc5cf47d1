// SPDX-License-Identifier: GPL-3.0-or-later
// What the readers of the formats of images share; included by core/image*.cpp only.
#pragma once

#include "core/image.h"
#include "core/math.h"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace scree {

/// A colour or data: a colour is converted to linear Rec. 709 and premultiplied, data stay as they
/// are stored.
enum class Meaning { color, data };

enum class ImageFormat { png, jpeg, exr, hdr };

/// Throws Error for a file that cannot be read or is of another format.
ImageFormat image_format(const std::string& path);

inline constexpr int max_image_side = 1 << 16;

/// Throws Error for an empty or too large image.
void check_image_size(const std::string& path, std::int64_t width, std::int64_t height,
                      std::size_t channels);

/// Warns of pixels that are not square: `aspect` is their width in their height.
void warn_of_aspect(const std::string& path, float aspect, const Warn& warn);

/// What an image's values mean: from what is stored to linear light, then from its primaries to
/// Rec. 709.
struct ColorEncoding {
    using Curve = std::function<float(float)>;
    std::array<Curve, 3> linear; // of red, green and blue; of grey the first
    std::optional<Imath::M33f>
        rec709_from_primaries; // row vectors: rgb * matrix; none: is Rec. 709
};

/// Converts values that are not premultiplied to linear Rec. 709 and premultiplies them.
void decode_colors(Image& image, const ColorEncoding& encoding);

/// Multiplies the colours of every pixel by a matrix.
void convert_primaries(Image& image, const Imath::M33f& rec709_from_primaries);

/// The image upright. `orientation` is that of EXIF, 1 to 8, where 1 is upright; others count as 1.
Image upright(Image image, int orientation);

Image read_exr_image(const std::string& path, Meaning meaning, const ImageOptions& options);
Image read_png_or_jpeg(const std::string& path, ImageFormat format, Meaning meaning,
                       const ImageOptions& options);
Image read_hdr(const std::string& path, Meaning meaning, const ImageOptions& options);

} // namespace scree
