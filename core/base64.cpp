// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base64.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace scree {

namespace {

constexpr std::string_view alphabet =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

} // namespace

std::string base64(std::string_view bytes) {
    std::string out;
    out.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t word = 0;
        for (std::size_t k = 0; k < 3; ++k)
            word = word << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k)
            out += k <= count ? alphabet[(word >> (18 - 6 * k)) & 63] : '=';
    }
    return out;
}

std::optional<std::string> base64_decoded(std::string_view text) {
    std::array<int, 256> digits{};
    digits.fill(-1);
    for (std::size_t i = 0; i < alphabet.size(); ++i)
        digits[static_cast<unsigned char>(alphabet[i])] = static_cast<int>(i);
    text = text.substr(0, text.find_last_not_of("= \t\r\n") + 1);
    std::string out;
    out.reserve(text.size() / 4 * 3);
    std::uint32_t word = 0;
    int bits = 0; // of `word` that are not yet in `out`
    for (const char c : text) {
        if (c == ' ' || c == '\t' || c == '\r' || c == '\n')
            continue;
        const int digit = digits[static_cast<unsigned char>(c)];
        if (digit < 0)
            return std::nullopt;
        word = word << 6 | static_cast<std::uint32_t>(digit);
        bits += 6;
        if (bits >= 8) {
            bits -= 8;
            out += static_cast<char>(word >> bits & 255);
        }
    }
    return bits < 6 ? std::optional(out) : std::nullopt;
}

} // namespace scree
