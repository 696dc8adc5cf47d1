// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/plane/region_tools.h"
#include "geometry/plane/svg/bezier_path.h"

#include <string>

namespace scree {

/// A filled shape of a drawing, in pixels of 1/96 inch; x right, y down.
struct SvgShape {
    BezierPath path;
    FillRule rule = FillRule::nonzero;
};

/// The filled shapes of an SVG file, or of its element with the id `element` when that is not
/// empty, with all transforms and viewBoxes applied. Throws Error naming the file's line for what
/// is no SVG, cannot be read, or has an area that would be lost silently (text, images, clones).
std::vector<SvgShape> read_svg(const std::string& path, const std::string& element);

/// The same for a file's bytes.
std::vector<SvgShape> read_svg_text(const std::string& bytes, const std::string& element);

} // namespace scree
