// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace scree {

/// Base64 of RFC 4648, padded, without line breaks.
std::string base64(std::string_view bytes);

/// The bytes of base64 with or without padding, blanks and line breaks; none when it has other
/// characters or ends within a byte.
std::optional<std::string> base64_decoded(std::string_view text);

} // namespace scree
