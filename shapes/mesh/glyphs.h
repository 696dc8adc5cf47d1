// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/plane/region.h"

namespace scree {

/// Height of all glyphs in the units of glyph_rings.
inline constexpr double glyph_height = 7;

/// The outline of the block letter for 'A' to 'Z', '0' to '9', '.' or '-' with its baseline at 0:
/// outer rings counter-clockwise, holes clockwise, strokes about 1.5 wide, corners rounded. Empty
/// for other characters.
std::vector<Ring> glyph_rings(char character);

} // namespace scree
