// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/image_tags.h"

#include "core/chromaticities.h"
#include "core/error.h"
#include "core/icc_profile.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>

namespace scree {

namespace {

constexpr std::size_t largest_profile = std::size_t{16} << 20;

std::uint32_t big_endian(std::string_view bytes, std::size_t at, std::size_t size) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < size; ++i)
        value =
            value << 8U | (at + i < bytes.size() ? static_cast<unsigned char>(bytes[at + i]) : 0U);
    return value;
}

/// An iCCP chunk: a name, 0, the method 0 and a zlib stream.
std::string unpacked(std::string_view chunk) {
    const std::size_t name = chunk.find('\0');
    const Error damaged("its embedded profile is damaged");
    if (name == std::string_view::npos || name + 2 > chunk.size())
        throw damaged;
    chunk.remove_prefix(name + 2);
    // The profile begins with its size.
    std::string out(4, '\0');
    for (int round = 0; round < 2; ++round) {
        auto size = static_cast<uLongf>(out.size());
        auto* to = reinterpret_cast<Bytef*>(out.data());
        const int code = uncompress(to, &size, reinterpret_cast<const Bytef*>(chunk.data()),
                                    static_cast<uLong>(chunk.size()));
        if (round == 1 && code == Z_OK && size == out.size())
            return out;
        const std::size_t whole = big_endian(out, 0, 4);
        if (round == 1 || size != 4 || whole < 128 || whole > largest_profile)
            throw damaged;
        out.resize(whole);
    }
    throw damaged;
}

/// ITU-T H.273, tables 2 and 3.
ColorEncoding cicp_encoding(std::string_view chunk) {
    const std::uint32_t primaries = big_endian(chunk, 0, 1);
    const std::uint32_t transfer = big_endian(chunk, 1, 1);
    ColorEncoding encoding;
    switch (transfer) {
    case 4:
        encoding = power_encoding(2.2);
        break;
    case 5:
        encoding = power_encoding(2.8);
        break;
    case 8:
        encoding = power_encoding(1);
        break;
    case 1:
    case 6:
    case 14:
    case 15: // Rec. 709, 601 and 2020, which are shown as sRGB is (PNG 3, annex C)
    case 13:
        encoding = srgb_encoding();
        break;
    default:
        throw Error(fmt::format("its cICP has the transfer function {}, which is not read; convert "
                                "it to sRGB",
                                transfer));
    }
    const Vec2 d65(0.3127, 0.3290);
    if (primaries == 9)
        encoding.rec709_from_primaries =
            rec709_from({{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}, d65});
    else if (primaries == 12)
        encoding.rec709_from_primaries =
            rec709_from({{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}, d65});
    else if (primaries != 1)
        throw Error(fmt::format("its cICP has the primaries {}, which are not read; convert it to "
                                "sRGB",
                                primaries));
    return encoding;
}

/// Adobe RGB (1998), section 4.3.
ColorEncoding adobe_rgb() {
    ColorEncoding encoding = power_encoding(563.0 / 256);
    encoding.rec709_from_primaries =
        rec709_from({{0.64, 0.33}, {0.21, 0.71}, {0.15, 0.06}, {0.3127, 0.3290}});
    return encoding;
}

ColorEncoding gamma_encoding(std::string_view chunk, const Warn& warn) {
    const double gamma = big_endian(chunk, 0, 4) / 1e5;
    if (gamma < 0.01 || gamma > 100)
        warn(fmt::format("its gAMA of {:g} is impossible; it is taken as sRGB", gamma));
    else if (gamma < 0.45 || gamma > 0.46)
        return power_encoding(1 / gamma);
    return srgb_encoding();
}

std::optional<Imath::M33f> primaries_of(std::string_view chunk) {
    const auto xy = [&](std::size_t i) {
        return Vec2(big_endian(chunk, 8 * i, 4), big_endian(chunk, 8 * i + 4, 4)) / 1e5;
    };
    const Chromaticities own;
    const Chromaticities given{xy(1), xy(2), xy(3), xy(0)};
    const auto same = [](const Vec2& a, const Vec2& b) { return (a - b).length() < 0.002; };
    if (same(given.red, own.red) && same(given.green, own.green) && same(given.blue, own.blue) &&
        same(given.white, own.white))
        return {};
    return rec709_from(given);
}

} // namespace

TaggedImage take_apart_png(std::string_view file) {
    constexpr std::string_view needed = "IHDR PLTE tRNS pHYs IDAT IEND";
    TaggedImage out;
    out.bytes = file.substr(0, 8);
    for (std::size_t at = 8; at < file.size();) {
        const std::string_view name =
            file.substr(at + std::min<std::size_t>(4, file.size() - at), 4);
        const std::size_t size = std::min<std::size_t>(big_endian(file, at, 4), file.size());
        const std::size_t end = std::min(at + 12 + size, file.size());
        const std::string_view data = file.substr(std::min(at + 8, file.size()), size);
        // Upper case marks what is critical; unknown ones of that kind are refused by libpng.
        if (name.empty() || needed.find(name) != std::string_view::npos || name[0] < 'a')
            out.bytes += file.substr(at, end - at);
        else if (name == "eXIf")
            out.exif = exif_facts(data);
        else if (name == "cICP" || name == "iCCP" || name == "sRGB" || name == "gAMA" ||
                 name == "cHRM")
            out.chunks.try_emplace(std::string(name), data);
        at = end;
    }
    return out;
}

TaggedImage take_apart_jpeg(std::string_view file) {
    TaggedImage out;
    std::map<std::uint32_t, std::string> profile; // by number, beginning with 1
    out.bytes = file.substr(0, 2);
    std::size_t at = 2;
    while (at + 4 <= file.size() && file[at] == '\xff') {
        const std::uint32_t marker = big_endian(file, at + 1, 1);
        if (marker == 0xff) { // padding
            ++at;
            continue;
        }
        const std::size_t end = std::min(at + 2 + big_endian(file, at + 2, 2), file.size());
        const std::string_view data = file.substr(at + 4, std::max(end, at + 4) - at - 4);
        // Frames are C0 to CF but for tables of codes (C4, CC) and the reserved C8.
        if (marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc)
            out.components = static_cast<int>(big_endian(data, 5, 1));
        if (marker == 0xe1 && data.starts_with(std::string_view("Exif\0\0", 6)))
            out.exif = exif_facts(data.substr(6));
        else if (marker == 0xe2 && data.starts_with(std::string_view("ICC_PROFILE\0", 12)))
            profile.try_emplace(big_endian(data, 12, 1),
                                data.substr(std::min<std::size_t>(14, data.size())));
        else if (marker < 0xe1 || marker == 0xee || (marker > 0xef && marker != 0xfe))
            out.bytes += file.substr(at, end - at); // JFIF and Adobe say how colours are coded
        at = end;
        if (marker == 0xda) // the pixels follow
            break;
    }
    out.bytes += file.substr(std::min(at, file.size()));
    for (const auto& [number, part] : profile)
        out.profile += part;
    return out;
}

ColorEncoding encoding_of(const TaggedImage& image, const Warn& warn) {
    const auto chunk = [&](const char* name) -> const std::string* {
        const auto found = image.chunks.find(name);
        return found == image.chunks.end() ? nullptr : &found->second;
    };
    if (const std::string* cicp = chunk("cICP"))
        return cicp_encoding(*cicp);
    if (const std::string* packed = chunk("iCCP"))
        return icc_encoding(unpacked(*packed));
    if (!image.profile.empty())
        return icc_encoding(image.profile);
    const std::string* gamma = chunk("gAMA");
    const std::string* primaries = chunk("cHRM");
    if (chunk("sRGB") == nullptr && (gamma != nullptr || primaries != nullptr)) {
        ColorEncoding encoding = gamma != nullptr ? gamma_encoding(*gamma, warn) : srgb_encoding();
        if (primaries != nullptr)
            encoding.rec709_from_primaries = primaries_of(*primaries);
        return encoding;
    }
    if (chunk("sRGB") == nullptr && image.exif.color_space == 2)
        return adobe_rgb();
    if (chunk("sRGB") == nullptr && image.exif.color_space == 65535)
        warn("its EXIF data say that it is not sRGB, and it has no profile; it is taken as sRGB");
    return srgb_encoding();
}

} // namespace scree
