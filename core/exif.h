// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace scree {

/// What EXIF data say of how a picture is to be shown.
struct ExifFacts {
    int orientation = 1; // 1 to 8, 1 is upright
    int color_space = 1; // 1: sRGB, 2: Adobe RGB (as cameras write it), 65535: another
};

/// Reads them from EXIF 2.3 data, which begin with the header of a TIFF. What is damaged counts as
/// not there.
ExifFacts exif_facts(std::string_view tiff);

} // namespace scree
