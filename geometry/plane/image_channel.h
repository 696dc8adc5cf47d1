// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/image.h"

namespace scree {

/// One number per pixel of an image read as data, row 0 at the top: `channel` is "luminance"
/// (Rec. 709 weights of the stored values), "r", "g", "b" or "a". A grey image has the same r, g
/// and b. Throws Error when the image has no such channel, and when a value is not finite, naming
/// the pixel.
std::vector<float> channel_values(const Image& image, const std::string& channel);

/// Whether the image has an alpha channel.
bool has_alpha(const Image& image);

} // namespace scree
