// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace scree {

/// Throws Error unless a data: URI holds a PNG or a JPEG, as base64, of at most 32 million pixels:
/// the library that draws it would take any size, and formats whose readers are less safe.
void check_embedded_picture(std::string_view uri);

} // namespace scree
