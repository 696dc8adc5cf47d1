// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image.h"

#include "core/error.h"
#include "core/file.h"
#include "core/image_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>

namespace scree {

namespace {

// 16384 x 8192 pixels of 4 float channels. A larger image in a scene is a mistake or an attack (a
// file of 300 bytes can claim any size).
constexpr std::uint64_t max_image_bytes = std::uint64_t{2} << 30;

/// Pixels of which the same is to be told: how many, and where the first one is.
struct Oddities {
    std::size_t count = 0;
    std::size_t first = 0;

    void add(std::size_t pixel) {
        if (count++ == 0)
            first = pixel;
    }

    std::string text(const Image& image) const {
        const std::string where = fmt::format("({}, {})", first % std::size_t(image.width),
                                              first / std::size_t(image.width));
        return count == 1 ? fmt::format("pixel {} is", where)
                          : fmt::format("{} pixels, the first at {}, are", count, where);
    }
};

/// Radiance and reflectance are finite and not negative, alpha lies between 0 and 1.
void make_physical(const std::string& path, Image& image, const Warn& warn) {
    constexpr float rounding = 1e-3F;
    const std::size_t stride = image.channels.size();
    const std::size_t colors = image.channels.back() == "A" ? stride - 1 : stride;
    Oddities infinite, negative, beyond;
    for (std::size_t i = 0; i < image.pixels.size() / stride; ++i) {
        float* pixel = &image.pixels[i * stride];
        if (!std::all_of(pixel, pixel + stride, [](float v) { return std::isfinite(v); })) {
            infinite.add(i);
            continue;
        }
        if (*std::min_element(pixel, pixel + colors) < 0)
            negative.add(i);
        for (std::size_t c = 0; c < colors; ++c)
            pixel[c] = std::max(pixel[c], 0.0F);
        if (colors < stride) {
            if (pixel[colors] < -rounding || pixel[colors] > 1 + rounding)
                beyond.add(i);
            pixel[colors] = std::clamp(pixel[colors], 0.0F, 1.0F);
        }
    }
    if (infinite.count > 0)
        throw Error(fmt::format("{}: {} not finite", path, infinite.text(image)));
    if (negative.count > 0)
        warn(fmt::format("{}: {} negative and taken as 0", path, negative.text(image)));
    if (beyond.count > 0)
        warn(fmt::format("{}: {} outside 0 to 1 in alpha and brought to its nearer end", path,
                         beyond.text(image)));
}

Image read_any_image(const std::string& path, Meaning meaning, const ImageOptions& options) {
    const ImageFormat format = image_format(path);
    if (!options.layer.empty() && format != ImageFormat::exr)
        throw Error(
            fmt::format("{}: has no layer \"{}\"; only EXR has layers", path, options.layer));
    switch (format) {
    case ImageFormat::exr:
        return read_exr_image(path, meaning, options);
    case ImageFormat::hdr:
        return read_hdr(path, meaning, options);
    default:
        return read_png_or_jpeg(path, format, meaning, options);
    }
}

} // namespace

// By content, since an extension may be wrong and OpenImageIO's other readers are not safe against
// malicious files.
ImageFormat image_format(const std::string& path) {
    check_is_file(path);
    std::array<unsigned char, 8> magic{};
    std::ifstream in(path, std::ios::binary);
    if (!in)
        throw Error(path + ": cannot be read: " + std::strerror(errno));
    in.read(reinterpret_cast<char*>(magic.data()), magic.size());
    const auto begins = [&](std::initializer_list<unsigned char> bytes) {
        return std::equal(bytes.begin(), bytes.end(), magic.begin());
    };
    if (begins({0x89, 'P', 'N', 'G', 0x0d, 0x0a, 0x1a, 0x0a}))
        return ImageFormat::png;
    if (begins({0xff, 0xd8, 0xff}))
        return ImageFormat::jpeg;
    if (begins({0x76, 0x2f, 0x31, 0x01}))
        return ImageFormat::exr;
    if (begins({'#', '?'}))
        return ImageFormat::hdr;
    throw Error(path + ": is not a PNG, JPEG, EXR or HDR image");
}

void check_image_size(const std::string& path, std::int64_t width, std::int64_t height,
                      std::size_t channels) {
    if (width < 1 || height < 1 || channels < 1)
        throw Error(path + ": is an empty image");
    if (width > max_image_side || height > max_image_side ||
        std::uint64_t(width) * std::uint64_t(height) * channels * sizeof(float) > max_image_bytes)
        throw Error(path + ": is too large: " + std::to_string(width) + " x " +
                    std::to_string(height) + " with " + std::to_string(channels) + " channels");
}

void warn_of_aspect(const std::string& path, float aspect, const Warn& warn) {
    if (aspect > 0 && std::abs(aspect - 1) > 1e-3F)
        warn(fmt::format("{}: its pixels are {:g} times as wide as high; they are taken as squares",
                         path, aspect));
}

Image read_image(const std::string& path, const ImageOptions& options) {
    Image image = read_any_image(path, Meaning::color, options);
    make_physical(path, image, options.warn);
    return image;
}

Image read_data_image(const std::string& path, const ImageOptions& options) {
    return read_any_image(path, Meaning::data, options);
}

} // namespace scree
