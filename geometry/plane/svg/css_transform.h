// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/plane/svg/svg_text.h"

#include <string_view>

namespace scree {

/// The property `transform` of CSS (Transforms 1): translate, scale, rotate, skew, their kinds for
/// one axis, and matrix, in px, other lengths, per cent of `box`, deg, grad, rad and turn. Throws
/// Error for others.
Affine css_transform(std::string_view text, const Vec2& box, double font_size);

/// A `transform-origin`: keywords, lengths and per cent of `box`; (0, 0) when empty.
Vec2 css_transform_origin(std::string_view text, const Box2& box, double font_size);

} // namespace scree
