// SPDX-License-Identifier: GPL-3.0-or-later
// From scene-linear light to a display: the only door to OpenColorIO.
#pragma once

#include "core/image.h"

#include <string>
#include <vector>

namespace scree {

/// `beauty` (R, G, B and possibly A; linear Rec. 709) made brighter by `exposure` stops and encoded
/// for the default display through `view` ("": the configuration's default). $OCIO names a
/// configuration; without it a small one of ours is used, with the views
///   filmic    AgX (Sobotka 2022): rolls highlights off and keeps their hue; the default
///   standard  plain sRGB encoding (IEC 61966-2-1), clipped
/// Throws Error (usage) for an unknown view and Error (input) for an unreadable $OCIO.
Image to_display(const Image& beauty, const std::string& view = {}, float exposure = 0);

/// The views of the configuration in use, its default first.
std::vector<std::string> view_names();

} // namespace scree
