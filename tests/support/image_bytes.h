// SPDX-License-Identifier: GPL-3.0-or-later
// Image files written byte by byte from their specifications, apart from the libraries that read
// them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <vector>

namespace scree::test {

inline std::string big_endian(std::uint32_t value, int bytes) {
    std::string out;
    for (int i = bytes - 1; i >= 0; --i)
        out += static_cast<char>(value >> (8 * i) & 0xff);
    return out;
}

template <class T>
std::string little_endian(T value) {
    char bytes[sizeof value];
    std::memcpy(bytes, &value, sizeof value); // tests run on little-endian machines
    return {bytes, sizeof value};
}

/// A PNG chunk: its length, kind, data and checksum (PNG 1.2, annex D).
inline std::string png_chunk(const std::string& kind, const std::string& data) {
    std::uint32_t crc = 0xffffffffU;
    for (const char c : kind + data) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc >> 1) ^ ((crc & 1) != 0 ? 0xedb88320U : 0U);
    }
    return big_endian(static_cast<std::uint32_t>(data.size()), 4) + kind + data +
           big_endian(~crc, 4);
}

/// zlib's format without compression, of less than 64 KiB (RFC 1950, 1951).
inline std::string stored(const std::string& data) {
    std::uint32_t a = 1, b = 0;
    for (const char c : data) {
        a = (a + static_cast<unsigned char>(c)) % 65521;
        b = (b + a) % 65521;
    }
    const auto size = static_cast<std::uint16_t>(data.size());
    return "\x78\x01\x01" + little_endian(size) + little_endian(std::uint16_t(~size)) + data +
           big_endian(b << 16 | a, 4);
}

/// A PNG of the given bits a channel and colour type (0 grey, 2 RGB, 3 palette, 4 grey and alpha, 6
/// RGBA) with the bytes of each row; `chunks` stand before the pixels.
inline std::string png_bytes_of(std::uint32_t width, int depth, int type,
                                const std::vector<std::string>& rows,
                                const std::string& chunks = {}) {
    std::string pixels;
    for (const std::string& row : rows)
        pixels += std::string(1, '\0') + row; // no filter
    const std::string header =
        big_endian(width, 4) + big_endian(static_cast<std::uint32_t>(rows.size()), 4) +
        static_cast<char>(depth) + static_cast<char>(type) + std::string(3, '\0');
    return "\x89PNG\r\n\x1a\n" + png_chunk("IHDR", header) + chunks +
           png_chunk("IDAT", stored(pixels)) + png_chunk("IEND", {});
}

/// EXIF data that hold an orientation (TIFF 6.0, tag 274).
inline std::string exif_bytes(int orientation) {
    return std::string("MM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01", 18) +
           big_endian(static_cast<std::uint32_t>(orientation), 2) + std::string(6, '\0');
}

/// An ICC profile of the given colour space with the tags (ICC.1:2010, section 7).
inline std::string icc_bytes(const std::string& space,
                             const std::vector<std::pair<std::string, std::string>>& tags) {
    std::string table = big_endian(static_cast<std::uint32_t>(tags.size()), 4);
    std::string data;
    const std::size_t start = 132 + 12 * tags.size();
    for (const auto& [name, tag] : tags) {
        table += name + big_endian(static_cast<std::uint32_t>(start + data.size()), 4) +
                 big_endian(static_cast<std::uint32_t>(tag.size()), 4);
        data += tag + std::string((4 - tag.size() % 4) % 4, '\0');
    }
    std::string header(128, '\0');
    header.replace(0, 4, big_endian(static_cast<std::uint32_t>(start + data.size()), 4));
    header.replace(8, 4, std::string("\x02\x40\0\0", 4));
    header.replace(12, 4, "mntr");
    header.replace(16, 4, space);
    header.replace(20, 4, "XYZ ");
    header.replace(36, 4, "acsp");
    header.replace(68, 12, big_endian(0xf6d6, 4) + big_endian(0x10000, 4) + big_endian(0xd32d, 4));
    return header + table + data;
}

inline std::string icc_fixed(double value) {
    return big_endian(static_cast<std::uint32_t>(static_cast<std::int32_t>(value * 65536)), 4);
}

inline std::string icc_xyz(double x, double y, double z) {
    return std::string("XYZ \0\0\0\0", 8) + icc_fixed(x) + icc_fixed(y) + icc_fixed(z);
}

/// The rows of a channel of an EXR, and how many pixels across and down share a value.
struct ExrChannel {
    std::vector<std::vector<float>> rows;
    int sampling = 1;
};

struct ExrWindow {
    std::int32_t x0, y0, x1, y1;
};

inline std::string exr_attribute(const std::string& name, const std::string& type,
                                 const std::string& value) {
    return name + '\0' + type + '\0' + little_endian(static_cast<std::int32_t>(value.size())) +
           value;
}

/// An uncompressed EXR of 32-bit floats in one part.
inline std::string exr_bytes(const std::map<std::string, ExrChannel>& channels,
                             const ExrWindow& data, const ExrWindow& display,
                             const std::string& attributes = {}, float aspect = 1) {
    const auto box = [](const ExrWindow& w) {
        return little_endian(w.x0) + little_endian(w.y0) + little_endian(w.x1) +
               little_endian(w.y1);
    };
    std::string list;
    for (const auto& [name, channel] : channels)
        list += name + '\0' + little_endian(2) + std::string(4, '\0') +
                little_endian(channel.sampling) + little_endian(channel.sampling);
    const std::string zero(1, '\0');
    const std::string header = std::string("\x76\x2f\x31\x01\x02\0\0\0", 8) +
                               exr_attribute("channels", "chlist", list + zero) +
                               exr_attribute("compression", "compression", zero) +
                               exr_attribute("dataWindow", "box2i", box(data)) +
                               exr_attribute("displayWindow", "box2i", box(display)) +
                               exr_attribute("lineOrder", "lineOrder", zero) +
                               exr_attribute("pixelAspectRatio", "float", little_endian(aspect)) +
                               exr_attribute("screenWindowCenter", "v2f", std::string(8, '\0')) +
                               exr_attribute("screenWindowWidth", "float", little_endian(1.0F)) +
                               attributes + zero;
    const int height = data.y1 - data.y0 + 1;
    std::string offsets, lines;
    for (int y = 0; y < height; ++y) {
        std::string line;
        for (const auto& [name, channel] : channels)
            if ((data.y0 + y) % channel.sampling == 0)
                for (const float v : channel.rows[std::size_t(y / channel.sampling)])
                    line += little_endian(v);
        offsets +=
            little_endian(std::uint64_t(header.size()) + std::uint64_t(height) * 8 + lines.size());
        lines += little_endian(data.y0 + y) +
                 little_endian(static_cast<std::int32_t>(line.size())) + line;
    }
    return header + offsets + lines;
}

/// Equal values in all pixels of a channel.
inline ExrChannel constant(int width, int height, float value, int sampling = 1) {
    return {std::vector(std::size_t(height / sampling),
                        std::vector<float>(std::size_t(width / sampling), value)),
            sampling};
}

/// A JPEG of 16 x 8 grey pixels, whose left half is black and the right one white; `segments` stand
/// at its beginning.
inline std::string jpeg_bytes(const std::string& segments = {}) {
    static const std::string hex =
        "ffdb00430001010101010101010101010101010101010101010101010101010101010101010101010101010101"
        "01"
        "0101010101010101010101010101010101010101010101ffc0000b080008001001011100ffc4001f0000010501"
        "01"
        "0101010100000000000000000102030405060708090a0bffc400b5100002010303020403050504040000017d01"
        "02"
        "0300041105122131410613516107227114328191a1082342b1c11552d1f02433627282090a161718191a252627"
        "28"
        "292a3435363738393a434445464748494a535455565758595a636465666768696a737475767778797a83848586"
        "87"
        "88898a92939495969798999aa2a3a4a5a6a7a8a9aab2b3b4b5b6b7b8b9bac2c3c4c5c6c7c8c9cad2d3d4d5d6d7"
        "d8"
        "d9dae1e2e3e4e5e6e7e8e9eaf1f2f3f4f5f6f7f8f9faffda0008010100003f00ff003ffaff007f8affd9";
    std::string out = "\xff\xd8" + segments;
    for (std::size_t i = 0; i < hex.size(); i += 2)
        out += static_cast<char>(std::stoi(hex.substr(i, 2), nullptr, 16));
    return out;
}

inline std::string jpeg_segment(int marker, const std::string& data) {
    return "\xff" + std::string(1, static_cast<char>(marker)) +
           big_endian(static_cast<std::uint32_t>(data.size() + 2), 2) + data;
}

} // namespace scree::test
