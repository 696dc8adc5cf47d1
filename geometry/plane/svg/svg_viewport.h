// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/plane/svg/svg_shapes.h"
#include "geometry/plane/svg/svg_style.h"

namespace scree {

/// Where an svg, or a symbol that is used, shows its contents.
struct SvgViewport {
    Affine outer_from_inner;
    Vec2 at{0.0};      // in the units around it
    Vec2 size{0.0};    // likewise; 0 where it is not known
    Vec2 inner{0.0};   // size in its own units, of which shares are taken
    bool drawn = true; // not of no width or height
};

/// The viewport of an element with the attributes of an svg (SVG 1.1, sections 7.7 to 7.9): its
/// viewBox is fitted into x, y, width and height. `outer` is what its own lengths are relative to,
/// `use` the element that shows it, whose width and height go first, or null. The outermost svg
/// has no place. Throws Error naming the attribute.
SvgViewport svg_viewport(const SvgNode& node, const SvgProperties& properties,
                         const SvgLengths& outer, const SvgProperties* use);

} // namespace scree
