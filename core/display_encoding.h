// SPDX-License-Identifier: GPL-3.0-or-later
// Conversion between linear light and the display encoding of IEC 61966-2-1 (sRGB).
#pragma once

#include "core/image.h"

#include <cmath>

namespace scree {

inline float linear_from_display(float v) {
    return v <= 0.04045F ? v / 12.92F : std::pow((v + 0.055F) / 1.055F, 2.4F);
}

inline float display_from_linear(float v) {
    return v <= 0.0031308F ? 12.92F * v : 1.055F * std::pow(v, 1 / 2.4F) - 0.055F;
}

/// Converts linear premultiplied R, G, B, A to what an 8-bit file holds: clamped to [0, 1],
/// display-encoded, not premultiplied; without A when alpha is 1 everywhere.
Image display_image(const Image& linear);

} // namespace scree
