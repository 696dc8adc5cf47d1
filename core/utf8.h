// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace scree {

/// A character of a UTF-8 text (RFC 3629).
struct Utf8Character {
    std::uint32_t code = 0;
    std::size_t bytes = 0; // 0: not UTF-8
};

/// The first character of a text that is not empty.
Utf8Character first_character(std::string_view text);

bool is_utf8(std::string_view text);

/// The text as a terminal may be given it: what controls a terminal, reverses the direction of
/// writing or is not UTF-8 is written as \x1b, byte by byte. Line ends and tabs stay.
std::string visible(std::string_view text);

} // namespace scree
