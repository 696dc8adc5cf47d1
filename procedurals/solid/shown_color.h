// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/display_encoding.h"
#include "core/math.h"

namespace scree {

/// The linear colour of the display-encoded (sRGB) colour 0xRRGGBB.
inline Color shown(unsigned rgb) {
    const auto part = [&](unsigned shift) {
        return linear_from_display(static_cast<float>((rgb >> shift) & 255U) / 255.0F);
    };
    return {part(16), part(8), part(0)};
}

} // namespace scree
