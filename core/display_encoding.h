// SPDX-License-Identifier: GPL-3.0-or-later
// Conversion between linear light and the display encoding of IEC 61966-2-1 (sRGB).
#pragma once

#include "core/image.h"

#include <cmath>
#include <concepts>

namespace scree {

template <std::floating_point T>
T linear_from_display(T v) {
    return v <= T(0.04045) ? v / T(12.92) : std::pow((v + T(0.055)) / T(1.055), T(2.4));
}

template <std::floating_point T>
T display_from_linear(T v) {
    return v <= T(0.0031308) ? T(12.92) * v : T(1.055) * std::pow(v, 1 / T(2.4)) - T(0.055);
}

/// Converts linear premultiplied R, G, B, A to what an 8-bit file holds: clamped to [0, 1],
/// display-encoded, not premultiplied; without A when alpha is 1 everywhere.
Image display_image(const Image& linear);

} // namespace scree
