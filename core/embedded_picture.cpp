// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/embedded_picture.h"

#include "core/base64.h"
#include "core/error.h"
#include "core/text.h"

#include <cstdint>
#include <fmt/format.h>

namespace scree {

namespace {

constexpr std::uint64_t most_pixels = std::uint64_t{32} << 20;

struct PixelSize {
    std::uint64_t width = 0, height = 0;
};

std::uint64_t big_endian(std::string_view bytes, std::size_t at, std::size_t count) {
    std::uint64_t value = 0;
    for (std::size_t i = at; i < at + count && i < bytes.size(); ++i)
        value = value << 8U | static_cast<unsigned char>(bytes[i]);
    return value;
}

// The size is in the first chunk (PNG 1.2, 4.1.1).
PixelSize png_size(std::string_view bytes) {
    return {big_endian(bytes, 16, 4), big_endian(bytes, 20, 4)};
}

// The size is in the frame header, among the segments before the data (ITU-T T.81, B.2.2).
PixelSize jpeg_size(std::string_view bytes) {
    std::size_t at = 2;
    while (at + 9 < bytes.size() && big_endian(bytes, at, 1) == 0xFF) {
        const std::uint64_t marker = big_endian(bytes, at + 1, 1);
        if (marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC)
            return {big_endian(bytes, at + 7, 2), big_endian(bytes, at + 5, 2)};
        at += marker == 0xFF ? 1 : 2 + std::size_t(big_endian(bytes, at + 2, 2));
    }
    return {};
}

} // namespace

void check_embedded_picture(std::string_view uri) {
    const std::size_t comma = uri.find(',');
    const std::string_view kind = trimmed(uri.substr(0, comma));
    const auto bytes = comma != std::string_view::npos && lower_case(kind).ends_with(";base64")
                           ? base64_decoded(uri.substr(comma + 1))
                           : std::nullopt;
    if (!bytes)
        throw Error("holds a picture that is not in base64");
    PixelSize size;
    if (bytes->starts_with("\x89PNG\r\n\x1a\n"))
        size = png_size(*bytes);
    else if (bytes->starts_with("\xff\xd8\xff"))
        size = jpeg_size(*bytes);
    if (size.width == 0 || size.height == 0)
        throw Error("holds what is no PNG or JPEG picture");
    if (size.width > most_pixels || size.height > most_pixels / size.width)
        throw Error(fmt::format("holds a picture of {} x {} pixels; at most {} are read",
                                size.width, size.height, most_pixels));
}

} // namespace scree
