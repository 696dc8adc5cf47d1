// SPDX-License-Identifier: GPL-3.0-or-later
// Layouts seen from above, x to the right and z down, as drawings.
#pragma once

#include "core/aggregate.h"
#include "core/image.h"

#include <functional>
#include <span>
#include <string>

namespace scree {

/// The display-encoded colour that an element is drawn with.
using ElementColor = std::function<Color(const Aggregate& aggregate, const Instance& instance)>;

/// The part of the ground that a picture of the aggregates shows [m]: domains and regions with a
/// border of a fiftieth. Throws Error when no aggregate has a domain or a region.
Box2 picture_box(std::span<const Aggregate> aggregates);

/// The shifts [m] at which an aggregate is drawn: (0, 0), and on a torus those of its neighbours.
std::vector<Vec2> picture_shifts(const Aggregate& aggregate);

/// SVG 1.1, in millimetres: one <path> with its holes per prototype in <defs>, one <use> with the
/// element's matrix per instance, and the domains' outlines. On a torus the copies of elements
/// around are there too, clipped at the domain.
std::string layout_svg(std::span<const Aggregate> aggregates, const ElementColor& color);

/// The same as a picture of `longest_side` pixels, anti-aliased and display-encoded.
Image layout_image(std::span<const Aggregate> aggregates, const ElementColor& color,
                   int longest_side);

} // namespace scree
