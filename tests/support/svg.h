// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/plane/region_tools.h"
#include "geometry/plane/svg/svg_document.h"

#include <string>

namespace scree::tests {

inline std::string svg(const std::string& body, const std::string& attributes = "") {
    return "<svg xmlns='http://www.w3.org/2000/svg' xmlns:xlink='http://www.w3.org/1999/xlink' " +
           attributes + ">" + body + "</svg>";
}

inline std::vector<FilledRings> flattened(const std::vector<SvgShape>& shapes) {
    std::vector<FilledRings> out;
    std::size_t points = 0;
    for (const SvgShape& shape : shapes)
        out.push_back({shape.path.flatten(1e-5, points, 1'000'000), shape.rule, shape.within});
    return out;
}

/// The union of what a drawing fills, in pixels.
inline Region svg_region(const std::string& text, const std::string& element = "",
                         const Warn& warn = no_warning) {
    const SvgDrawing drawing = read_svg_text(text, element, warn);
    Clips clips;
    for (const std::vector<SvgShape>& clip : drawing.clips)
        clips.push_back(flattened(clip));
    return fill(flattened(drawing.shapes), clips);
}

} // namespace scree::tests
