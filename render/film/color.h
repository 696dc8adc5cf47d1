// SPDX-License-Identifier: GPL-3.0-or-later
// From linear light to what a screen shows: the only door to OpenColorIO.
#pragma once

#include "core/image.h"

#include <string>
#include <vector>

namespace scree {

/// Names of all views, the default one first: our own "filmic", "standard" (sRGB) and "raw" (the
/// linear values as they are), or those of the configuration that $OCIO names. Throws Error (input)
/// when that cannot be read.
std::vector<std::string> view_names();

/// The picture as a view shows it: R, G, B ready for an sRGB screen, mostly in [0, 1]. `beauty` has
/// the channels R, G, B (others are dropped) or one grey one, linear Rec. 709; `view` "" is the
/// default view; `exposure` [stops] comes first. Throws Error (usage) on an unknown view.
Image to_display(const Image& beauty, const std::string& view = "", double exposure = 0);

/// How a .png shows a picture.
struct PngLook {
    std::string view{}; // as of to_display
    float exposure = 0; // [stops]
    PngDepth depth = PngDepth::eight;
};

/// The tone curve of "filmic": straight in the middle, with a toe and a shoulder that reaches 1
/// only at infinity (Uchimura 2017, "HDR theory and practice", with its default parameters).
double filmic_curve(double linear);

/// How much of each of the other channels "filmic" adds to a channel before the curve, and takes
/// off again after it: bright saturated colours turn white as they do on film, rather than clip to
/// a primary (Sobotka 2022, "AgX"). Greys and what lies on the straight part stay as they are.
inline constexpr double filmic_crosstalk = 0.08;

} // namespace scree
