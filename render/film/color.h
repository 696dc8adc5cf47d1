// SPDX-License-Identifier: GPL-3.0-or-later
// From linear light to what a screen shows: the only door to OpenColorIO.
#pragma once

#include "core/image.h"

#include <string>
#include <vector>

namespace scree {

/// Names of all views, the default one first: our own "filmic" and "standard", or those
/// of the configuration that $OCIO names. Throws Error (input) when that cannot be read.
std::vector<std::string> view_names();

/// The picture as a view shows it: R, G, B ready for an sRGB screen, mostly in [0, 1]. `beauty` has
/// the channels R, G, B (others are dropped) or one grey one, linear Rec. 709; `view` "" is the
/// default view; `exposure` [stops] comes first. Throws Error (usage) on an unknown view.
Image to_display(const Image& beauty, const std::string& view = "", double exposure = 0);

/// The tone curve of "filmic": straight in the middle, with a toe and a shoulder that reaches 1
/// only at infinity (Uchimura 2017, "HDR theory and practice", with its default parameters).
double filmic_curve(double linear);

} // namespace scree
