// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image.h"

#include "core/error.h"
#include "core/file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace scree {

namespace {

// 8 x 8 ordered dither (Bayer 1973). The thresholds lie in (0, 1), so values that are exact 8-bit
// steps stay unchanged.
float dither(int x, int y) {
    int rank = 0;
    for (int bit = 0; bit < 3; ++bit) {
        const int a = ((x ^ y) >> bit) & 1;
        const int b = (y >> bit) & 1;
        rank |= ((a << 1) | b) << (2 * (2 - bit));
    }
    return (static_cast<float>(rank) + 0.5F) / 64.0F;
}

// The channels' values as whole steps from 0 to the largest Step; NaN as 0.
template <class Step, class Rounding>
std::vector<Step> quantized(const Image& image, const Rounding& rounding) {
    constexpr auto largest = static_cast<float>(std::numeric_limits<Step>::max());
    std::vector<Step> steps(image.pixels.size());
    std::size_t i = 0;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (std::size_t c = 0; c < image.channels.size(); ++c, ++i) {
                const float v = std::clamp(image.pixels[i], 0.0F, 1.0F); // NaN stays NaN
                const float step = std::isnan(v) ? 0.0F : v * largest + rounding(x, y);
                steps[i] = static_cast<Step>(std::min(step, largest));
            }
    return steps;
}

} // namespace

std::string png_bytes(const Image& image, const Metadata& metadata, PngDepth depth) {
    const int channels = static_cast<int>(image.channels.size());
    const OIIO::TypeDesc type = depth == PngDepth::sixteen ? OIIO::TypeUInt16 : OIIO::TypeUInt8;
    OIIO::ImageSpec spec(image.width, image.height, channels, type);
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("oiio:UnassociatedAlpha", 1);
    for (const auto& [name, value] : metadata)
        spec.attribute(name, value);
    // Written to memory first: OpenImageIO's PNG writer reports success on a full disk; write_file
    // reports the failure.
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    const auto output = OIIO::ImageOutput::create("memory.png", &memory);
    const auto write_pixels = [&] {
        if (depth == PngDepth::eight)
            return output->write_image(type, quantized<std::uint8_t>(image, dither).data());
        const auto half = [](int, int) { return 0.5F; };
        return output->write_image(type, quantized<std::uint16_t>(image, half).data());
    };
    if (!output || !output->open("memory.png", spec) || !write_pixels() || !output->close())
        throw Error::resource("cannot make a PNG: " +
                              (output ? output->geterror() : OIIO::geterror()));
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

void write_png(const std::string& path, const Image& image, const Metadata& metadata,
               PngDepth depth) {
    write_file(path, png_bytes(image, metadata, depth));
}

} // namespace scree
