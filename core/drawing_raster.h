// SPDX-License-Identifier: GPL-3.0-or-later
// Rasterises SVG drawings: the only place that uses librsvg and cairo.
#pragma once

#include "core/image.h"
#include "core/math.h"

#include <string>

namespace scree {

/// The size given by the drawing's width, height and viewBox [pixels of 1/96 inch]. Throws Error
/// when the text is not SVG or gives no size.
Vec2 drawing_size(const std::string& markup);

/// Rasterises a drawing of the given `size` to width x height pixels of linear, premultiplied R, G,
/// B, A. It cannot read other files or the network. Throws Error when it cannot be drawn.
Image rasterised(const std::string& markup, const Vec2& size, int width, int height);

} // namespace scree
