// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/utf8.h"

namespace scree {

namespace {

bool controls_a_terminal(std::uint32_t code) {
    const bool is_control =
        (code < 0x20 && code != '\n' && code != '\t') || (code >= 0x7F && code < 0xA0);
    const bool turns_writing = code == 0x061C || code == 0x200E || code == 0x200F ||
                               (code >= 0x202A && code <= 0x202E) ||
                               (code >= 0x2066 && code <= 0x2069);
    return is_control || turns_writing;
}

} // namespace

Utf8Character first_character(std::string_view text) {
    const auto first = static_cast<unsigned char>(text.front());
    if (first < 0x80)
        return {first, 1};
    if (first < 0xC0 || first >= 0xF8)
        return {};
    const std::size_t more = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : 1;
    if (text.size() <= more)
        return {};
    std::uint32_t code = first & (0x3FU >> more);
    for (std::size_t i = 1; i <= more; ++i) {
        const auto next = static_cast<unsigned char>(text[i]);
        if ((next & 0xC0U) != 0x80)
            return {};
        code = code << 6U | (next & 0x3FU);
    }
    constexpr std::uint32_t smallest[] = {0, 0x80, 0x800, 0x10000};
    if (code < smallest[more] || code > 0x10FFFF || (code >= 0xD800 && code <= 0xDFFF))
        return {};
    return {code, more + 1};
}

bool is_utf8(std::string_view text) {
    while (!text.empty()) {
        const std::size_t bytes = first_character(text).bytes;
        if (bytes == 0)
            return false;
        text.remove_prefix(bytes);
    }
    return true;
}

std::string visible(std::string_view text) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string out;
    while (!text.empty()) {
        const Utf8Character character = first_character(text);
        const bool shown = character.bytes > 0 && !controls_a_terminal(character.code);
        const std::string_view bytes = text.substr(0, character.bytes == 0 ? 1 : character.bytes);
        if (shown)
            out += bytes;
        else
            for (const char byte : bytes) {
                const auto value = static_cast<unsigned char>(byte);
                out += {'\\', 'x', digits[value / 16], digits[value % 16]};
            }
        text.remove_prefix(bytes.size());
    }
    return out;
}

} // namespace scree
