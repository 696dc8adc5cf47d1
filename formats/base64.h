// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace scree {

/// Base64 of RFC 4648, padded, without line breaks.
std::string base64(std::string_view bytes);

} // namespace scree
