// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/plane/svg/svg_text.h"

#include <functional>
#include <optional>
#include <string>

namespace scree {

/// What lengths of an element are relative to.
struct SvgLengths {
    Vec2 viewport{0.0};    // size of the nearest svg in the element's units; 0: not known
    double font_size = 16; // [pixels]

    /// Shares of the width for x, width, cx and rx, of the height for y, height, cy and ry, and of
    /// the diagonal over the root of 2 for others.
    LengthBase base(std::string_view name) const;
};

/// The attributes of an element by name, and what their lengths are relative to.
struct Attribute {
    std::function<std::optional<std::string>(const std::string& name)> value;
    SvgLengths lengths{};

    std::optional<std::string> operator()(const std::string& name) const { return value(name); }
};

/// The outline of a `path`, `rect`, `circle`, `ellipse`, `polygon` or `polyline` in its own units;
/// empty where SVG draws nothing, as for a circle of radius 0. Throws Error "name: what is wrong".
BezierPath svg_shape(const std::string& element, const Attribute& attribute);

/// Whether `svg_shape` knows the element.
bool is_svg_shape(const std::string& element);

/// A length of the element in pixels, or `otherwise` when it is not given.
double svg_length(const Attribute& attribute, const std::string& name, double otherwise);

} // namespace scree
