// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image_reading.h"

#include <utility>

namespace scree {

namespace {

std::size_t color_count(const Image& image) { return image.channels.size() <= 2 ? 1 : 3; }

Imath::V3f converted(const float* pixel, const Imath::M33f& matrix) {
    return Imath::V3f(pixel[0], pixel[1], pixel[2]) * matrix;
}

} // namespace

void decode_colors(Image& image, const ColorEncoding& encoding) {
    const std::size_t stride = image.channels.size();
    const std::size_t colors = color_count(image);
    for (std::size_t i = 0; i < image.pixels.size(); i += stride) {
        float* pixel = &image.pixels[i];
        for (std::size_t c = 0; c < colors; ++c)
            pixel[c] = encoding.linear[c](pixel[c]);
        if (encoding.rec709_from_primaries && colors == 3) {
            const Imath::V3f color = converted(pixel, *encoding.rec709_from_primaries);
            for (unsigned c = 0; c < 3; ++c)
                pixel[c] = color[c];
        }
        if (stride > colors)
            for (std::size_t c = 0; c < colors; ++c)
                pixel[c] *= pixel[colors];
    }
}

void convert_primaries(Image& image, const Imath::M33f& rec709_from_primaries) {
    const std::size_t stride = image.channels.size();
    for (std::size_t i = 0; i < image.pixels.size(); i += stride) {
        const Imath::V3f color = converted(&image.pixels[i], rec709_from_primaries);
        for (unsigned c = 0; c < 3; ++c)
            image.pixels[i + c] = color[c];
    }
}

// EXIF 2.3, section 4.6.4: where row 0 and column 0 of the stored image are seen.
Image upright(Image image, int orientation) {
    if (orientation < 2 || orientation > 8)
        return image;
    const bool transposed = orientation >= 5;
    const bool from_right = orientation == 2 || orientation == 3 || orientation == 6 ||
                            orientation == 7; // what is seen at the left is stored last
    const bool from_bottom = orientation == 3 || orientation == 4 || orientation == 7 ||
                             orientation == 8; // what is seen on top is stored last
    Image out(transposed ? image.height : image.width, transposed ? image.width : image.height,
              std::move(image.channels));
    const std::size_t stride = out.channels.size();
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            int column = from_right ? out.width - 1 - x : x;
            int row = from_bottom ? out.height - 1 - y : y;
            if (transposed)
                std::swap(column, row);
            const std::size_t from =
                (std::size_t(row) * std::size_t(image.width) + std::size_t(column)) * stride;
            std::copy_n(&image.pixels[from], stride, out.at(x, y));
        }
    return out;
}

} // namespace scree
