// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image_reading.h"

#include <string_view>

namespace scree {

/// What the values of a picture with this ICC profile (ICC.1:2010) mean. Profiles of a matrix and
/// curves, and those of grey, are read; one that is sRGB but for rounding gives exactly sRGB.
/// Throws Error for lookup tables, other colour spaces such as CMYK, and damaged ones.
ColorEncoding icc_encoding(std::string_view profile);

/// IEC 61966-2-1.
ColorEncoding srgb_encoding();

/// Values raised to a power.
ColorEncoding power_encoding(double exponent);

} // namespace scree
