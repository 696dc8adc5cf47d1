// SPDX-License-Identifier: GPL-3.0-or-later
// Colours in terms of other primaries.
#pragma once

#include "core/math.h"

namespace scree {

/// CIE 1931 x, y of red, green, blue and white. The defaults are those of Rec. 709.
struct Chromaticities {
    Vec2 red{0.64, 0.33};
    Vec2 green{0.30, 0.60};
    Vec2 blue{0.15, 0.06};
    Vec2 white{0.3127, 0.3290};

    bool operator==(const Chromaticities& other) const = default;
};

/// White of the profile connection space of ICC.1:2010, D50 [XYZ with Y = 1].
inline const Imath::V3d icc_white{0.9642, 1.0, 0.8249};

/// XYZ with Y = 1 for white, as a row vector: rgb * matrix. Throws Error when the primaries span no
/// colours: on one line, or with y of 0.
Imath::M33d xyz_from_rgb(const Chromaticities& primaries);

/// Linear Rec. 709 from linear values of other primaries: rgb * matrix. White stays white, by
/// Bradford's adaptation (Lam 1985). Throws Error as `xyz_from_rgb`.
Imath::M33f rec709_from(const Chromaticities& primaries);

/// Linear Rec. 709 from XYZ that are relative to a white [XYZ], likewise adapted.
Imath::M33f rec709_from_xyz(const Imath::V3d& white);

} // namespace scree
