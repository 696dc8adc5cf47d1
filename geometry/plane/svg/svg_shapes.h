// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/plane/svg/bezier_path.h"

#include <functional>
#include <optional>
#include <string>

namespace scree {

/// The value of an attribute, or none.
using Attribute = std::function<std::optional<std::string>(const std::string& name)>;

/// The outline of a `path`, `rect`, `circle`, `ellipse`, `polygon` or `polyline` in its own units;
/// empty where SVG draws nothing, as for a circle of radius 0. Throws Error "name: what is wrong".
BezierPath svg_shape(const std::string& element, const Attribute& attribute);

/// Whether `svg_shape` knows the element.
bool is_svg_shape(const std::string& element);

/// A length of the element in pixels, or `otherwise` when it is not given.
double svg_length(const Attribute& attribute, const std::string& name, double otherwise);

} // namespace scree
