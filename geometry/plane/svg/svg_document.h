// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/warn.h"
#include "geometry/plane/region_tools.h"
#include "geometry/plane/svg/bezier_path.h"

#include <string>

namespace scree {

/// A filled shape of a drawing, in pixels of 1/96 inch; x right, y down.
struct SvgShape {
    BezierPath path;
    FillRule rule = FillRule::nonzero;
    std::vector<std::size_t> within{}; // indices of the clips that cut it
};

/// What a drawing fills: all of its shapes, each cut by all of its clips.
struct SvgDrawing {
    std::vector<SvgShape> shapes;
    std::vector<std::vector<SvgShape>> clips; // the union of their shapes
};

/// The filled shapes of an SVG file that can be seen, or of its element with the id `element` when
/// that is not empty, which shows even in defs. Style sheets, transforms, viewBoxes, clones,
/// switches and clips are applied. The drawing's page cuts nothing.
///
/// Warns of strokes, markers and filters, and of what reaches beyond the page. Throws Error naming
/// the file's line for what is no SVG, cannot be read, or has an area that would be lost silently,
/// such as text, images, patterns and masks.
SvgDrawing read_svg(const std::string& path, const std::string& element, const Warn& warn);

/// The same for a file's bytes.
SvgDrawing read_svg_text(const std::string& bytes, const std::string& element,
                         const Warn& warn = no_warning);

} // namespace scree
