// SPDX-License-Identifier: GPL-3.0-or-later
// SVG drawings as pixels: the only door to librsvg and cairo.
#pragma once

#include "core/image.h"
#include "core/math.h"

#include <string>

namespace scree {

/// The size that the drawing's width, height and viewBox say [pixels of 1/96 inch]. Throws Error
/// when it is no SVG, or says none.
Vec2 drawing_size(const std::string& markup);

/// The drawing, which fills a rectangle of its own `size`, as R, G, B, A: linear, multiplied by
/// alpha. It sees no other file and no network. Throws Error when it cannot be drawn.
Image rasterised(const std::string& markup, const Vec2& size, int width, int height);

} // namespace scree
